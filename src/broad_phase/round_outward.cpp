// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "broad_phase/round_outward.h"

#include "geometry/lanes/lane_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "broad_phase/round_outward.cpp"
#include <hwy/foreach_target.h>  // compiles what follows up to HWY_ONCE for every instruction set
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Use no templates of the standard library here. The linker would keep one copy of each, perhaps
// one that this machine cannot run.
using Doubles = hn::CappedTag<double, 4>;
using Floats = hn::Rebind<float, Doubles>;

constexpr float kGreatest = 3.402823466e+38F;
constexpr float kLeast = 1.175494351e-38F;
constexpr float kPlace = 1.1920929e-07F;

HWY_INLINE hn::Vec<Floats> nearest(const double* corner) {
  const Doubles doubles;
  const auto greatest = hn::Set(doubles, static_cast<double>(kGreatest));
  const auto clamped = hn::Clamp(hn::LoadU(doubles, corner), hn::Neg(greatest), greatest);
  return hn::DemoteTo(Floats(), clamped);
}

HWY_INLINE hn::Vec<Floats> stepOf(hn::Vec<Floats> value) {
  const Floats floats;
  return hn::Add(hn::Mul(hn::Abs(value), hn::Set(floats, kPlace)), hn::Set(floats, kLeast));
}

void roundBoxes(const double* corners, std::size_t count, float* rounded) {
  for (std::size_t box = 0; box < count; ++box, corners += 6, rounded += 8) {
    for (std::size_t axis = 0; axis < 4; axis += hn::Lanes(Doubles())) {
      const auto min = nearest(corners + axis);
      const auto max = nearest(corners + 3 + axis);
      hn::StoreU(hn::Sub(min, stepOf(min)), Floats(), rounded + axis);
      hn::StoreU(hn::Add(max, stepOf(max)), Floats(), rounded + 4 + axis);
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace collision_monitor {
namespace {

HWY_EXPORT(roundBoxes);

}  // namespace

void roundOutward(const double* corners, std::size_t count, float* rounded) noexcept {
  HWY_DYNAMIC_DISPATCH(roundBoxes)(corners, count, rounded);
}

}  // namespace collision_monitor
#endif
