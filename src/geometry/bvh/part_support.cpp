// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "geometry/bvh/part_support.cpp"
#include "hwy/foreach_target.h"
// The order matters: Highway first includes this file once for each target.
#include <array>
#include <limits>

#include "geometry/bvh/part_support.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// The first of the farthest corners.
std::uint32_t farthestCorner(const PartCorners& corners, PartCorners::Range range,
                             const float* direction) {
  using Many = hn::CappedTag<float, PartCorners::kStep>;
  using Codes = hn::Rebind<std::int32_t, Many>;
  const auto lanes = static_cast<std::uint32_t>(hn::Lanes(Many()));
  const auto x = hn::Set(Many(), direction[0]);
  const auto y = hn::Set(Many(), direction[1]);
  const auto z = hn::Set(Many(), direction[2]);
  auto reach = hn::Set(Many(), -std::numeric_limits<float>::infinity());
  auto index = hn::Iota(Codes(), static_cast<std::int32_t>(range.first));
  auto farthest = index;
  for (std::uint32_t i = range.first; i < range.last; i += lanes) {
    // No fused multiply-add, so that every instruction set rounds alike.
    const auto here = hn::Add(hn::Add(hn::Mul(x, hn::Load(Many(), corners.along(0, i))),
                                      hn::Mul(y, hn::Load(Many(), corners.along(1, i)))),
                              hn::Mul(z, hn::Load(Many(), corners.along(2, i))));
    const auto is_farther = hn::Gt(here, reach);
    reach = hn::IfThenElse(is_farther, here, reach);
    farthest = hn::IfThenElse(hn::RebindMask(Codes(), is_farther), index, farthest);
    index = hn::Add(index, hn::Set(Codes(), static_cast<std::int32_t>(lanes)));
  }
  alignas(64) std::array<float, PartCorners::kStep> reaches;
  alignas(64) std::array<std::int32_t, PartCorners::kStep> found;
  hn::Store(reach, Many(), reaches.data());
  hn::Store(farthest, Codes(), found.data());
  std::size_t best = 0;
  for (std::size_t i = 1; i < lanes; ++i) {
    const bool is_first = reaches[i] == reaches[best] && found[i] < found[best];
    best = reaches[i] > reaches[best] || is_first ? i : best;
  }
  return static_cast<std::uint32_t>(found[best]);
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace collision_monitor {
namespace {
HWY_EXPORT(farthestCorner);
}  // namespace

Eigen::Vector3d farthestOfPart(const MeshTree& mesh, std::uint32_t node,
                               const Eigen::Vector3d& direction) noexcept {
  const PartCorners& corners = mesh.partCorners();
  const Eigen::Vector3f unit = direction.normalized().cast<float>();
  const std::uint32_t at =
      HWY_DYNAMIC_DISPATCH(farthestCorner)(corners, corners.of(node), unit.data());
  return mesh.center() +
         Eigen::Vector3f(*corners.along(0, at), *corners.along(1, at), *corners.along(2, at))
             .cast<double>();
}

}  // namespace collision_monitor
#endif
