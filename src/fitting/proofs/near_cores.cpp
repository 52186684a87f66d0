// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/proofs/near_cores.h"

#include "geometry/lanes/lane_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fitting/proofs/near_cores.cpp"
#include "hwy/foreach_target.h"
// The order matters: Highway first includes this file once for each target.
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Doubles = hn::CappedTag<double, 8>;
using Lanes = hn::Vec<Doubles>;

/// Whether points are inside a core. No fused multiply-add, so that every instruction set rounds
/// alike.
hn::Mask<Doubles> areHeld(const TurnedCore& core, const Lanes* point) {
  const Doubles tag;
  Lanes from_center[3];
  for (int i = 0; i < 3; ++i) {
    from_center[i] = hn::Sub(point[i], hn::Set(tag, core.center[i]));
  }
  const auto product = [&](int row, int column) {
    return hn::Mul(hn::Set(tag, core.rotation(row, column)), from_center[row]);
  };
  Lanes farthest = hn::Set(tag, -1.0);
  Lanes squared = hn::Zero(tag);
  for (int k = 0; k < 3; ++k) {
    const Lanes along = hn::Add(product(0, k), hn::Add(product(1, k), product(2, k)));
    const Lanes out = hn::Sub(hn::Abs(along), hn::Set(tag, core.half_extents[k]));
    const Lanes beyond = hn::Max(out, hn::Zero(tag));
    farthest = k == 0 ? out : hn::Max(farthest, out);
    squared = hn::Add(squared, hn::Mul(beyond, beyond));
  }
  return hn::Or(hn::Lt(farthest, hn::Zero(tag)),
                hn::Lt(squared, hn::Set(tag, core.radius * core.radius)));
}

void markInLanes(const std::vector<const TurnedCore*>& cores, const PointRows& points,
                 unsigned char* is_held) {
  const Doubles tag;
  const std::size_t step = hn::Lanes(tag);
  for (std::size_t first = 0; first < points.count; first += step) {
    const Lanes point[3] = {hn::Load(tag, points.at[0] + first),
                            hn::Load(tag, points.at[1] + first),
                            hn::Load(tag, points.at[2] + first)};
    hn::Mask<Doubles> held = hn::Lt(hn::Zero(tag), hn::Zero(tag));
    for (const TurnedCore* core : cores) {
      held = hn::Or(held, areHeld(*core, point));
    }
    std::uint8_t bits[8] = {};  // Highway may write eight bytes
    hn::StoreMaskBits(tag, held, bits);
    for (std::size_t i = 0; i < step; ++i) {
      is_held[first + i] = static_cast<unsigned char>(bits[0] >> i & 1U);
    }
  }
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace collision_monitor {
namespace {

HWY_EXPORT(markInLanes);

double reachOf(const TurnedCore& core) noexcept { return core.half_extents.norm() + core.radius; }

/// [m] From the core without its radius.
double distanceTo(const TurnedCore& core, const Eigen::Vector3d& point) noexcept {
  const Eigen::Vector3d out =
      (core.rotation.transpose() * (point - core.center)).cwiseAbs() - core.half_extents;
  return out.cwiseMax(0.0).norm();
}

}  // namespace

NearCores::NearCores(const std::vector<TurnedCore>& all, const TurnedCore& core, double slack) {
  constexpr double kRounding = 1.0 + 1e-9;
  const double reach = reachOf(core) + slack;
  for (const TurnedCore& other : all) {
    if (distanceTo(other, core.center) <= kRounding * (reach + other.radius)) {
      near_.push_back(&other);
    }
  }
}

void NearCores::mark(const PointRows& points,
                     std::array<unsigned char, PointRows::kMost>& is_held) const noexcept {
  HWY_DYNAMIC_DISPATCH(markInLanes)(near_, points, is_held.data());
}

}  // namespace collision_monitor
#endif
