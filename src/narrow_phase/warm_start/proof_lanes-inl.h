// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause

// What proofs of many pairs at once share: poses of cores, one pair per lane, and their reach.
#if defined(COLLISION_MONITOR_PROOF_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COLLISION_MONITOR_PROOF_LANES_INL_H_
#undef COLLISION_MONITOR_PROOF_LANES_INL_H_
#else
#define COLLISION_MONITOR_PROOF_LANES_INL_H_
#endif

#include <algorithm>
#include <limits>

#include "geometry/lanes/turn_rows-inl.h"
#include "narrow_phase/gjk/support_plane.h"
#include "narrow_phase/warm_start/proof_rows.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

/// Rows in lanes, from `first` on. The last row stands for those after it.
struct RowLanes {
  std::size_t count;
  std::size_t first;

  HWY_INLINE std::size_t row(std::size_t lane) const { return std::min(first + lane, count - 1); }
};

struct PlacedAxes {
  Axes axes;
  Vector3 origin;
};

HWY_INLINE PlacedAxes placeOf(const std::array<ProofSide, kProofRows>& sides,
                              const RowLanes& lanes) {
  const auto four = [&](std::size_t from) HWY_ATTR {
    return turnRows([&](std::size_t lane)
                        HWY_ATTR { return sides[lanes.row(lane)].world_from_core + from; });
  };
  const FourNumbers a = four(0);
  const FourNumbers b = four(4);
  const FourNumbers c = four(8);
  return {{{a.at[0], a.at[1], a.at[2]}, {a.at[3], b.at[0], b.at[1]}, {b.at[2], b.at[3], c.at[0]}},
          {c.at[1], c.at[2], c.at[3]}};
}

template <class Rows>
HWY_INLINE void store(Number value, std::size_t column, std::size_t row, Rows& rows) {
  hn::Store(value, Lanes(), &rows.at[column][row]);
}

template <class Rows>
HWY_INLINE void store(const Vector3& v, std::size_t column, std::size_t row, Rows& rows) {
  store(v.x, column, row, rows);
  store(v.y, column + 1, row, rows);
  store(v.z, column + 2, row, rows);
}

template <class Rows>
HWY_INLINE Number load(std::size_t column, std::size_t row, const Rows& rows) {
  return hn::Load(Lanes(), &rows.at[column][row]);
}

HWY_INLINE Number distanceWhere(Truth is_known, Number distance) {
  return hn::IfThenElse(is_known, distance, number(std::numeric_limits<double>::quiet_NaN()));
}

/// touchingDistance() of convex_pair.h.
HWY_INLINE Number touchingDistanceOf(Number size) {
  return hn::Max(number(kTouching), hn::Mul(number(roundingOf(1.0)), size));
}

template <class Rows>
HWY_INLINE Eigen::Vector3d vectorAt(std::size_t column, std::size_t row, const Rows& rows) {
  return {rows.at[column][row], rows.at[column + 1][row], rows.at[column + 2][row]};
}

using OfFan = hn::CappedTag<double, ConvexHull::Fan::kSize>;

/// ConvexHull::reachBeside.
HWY_INLINE double reachBeside(const ConvexHull::Fans& fans, const Eigen::Vector3d& direction) {
  const auto x = hn::Set(OfFan(), direction.x());
  const auto y = hn::Set(OfFan(), direction.y());
  const auto z = hn::Set(OfFan(), direction.z());
  auto most = hn::Set(OfFan(), -std::numeric_limits<double>::infinity());
  for (const ConvexHull::Fan& fan : fans) {
    for (std::size_t i = 0; i < ConvexHull::Fan::kSize; i += hn::Lanes(OfFan())) {
      const auto of_xy = hn::Add(hn::Mul(x, hn::LoadU(OfFan(), fan.x.data() + i)),
                                 hn::Mul(y, hn::LoadU(OfFan(), fan.y.data() + i)));
      most = hn::Max(most, hn::Add(of_xy, hn::Mul(z, hn::LoadU(OfFan(), fan.z.data() + i))));
    }
  }
  return hn::GetLane(hn::MaxOfLanes(OfFan(), most));
}

HWY_INLINE ExtremeFeature extremeOfSide(const ProofSide& side, const Eigen::Vector3d& direction) {
  if (side.hull == nullptr) {
    const std::array<double, 3>& half = side.half_extents;
    return extremeOfBox({half[0], half[1], half[2]}, direction);
  }
  const ConvexHull& hull = *side.hull;
  return extremeFrom(
      {side.vertex, collision_monitor::along(direction, hull.vertices()[side.vertex]),
       reachBeside(hull.fansOf(side.vertex), direction)},
      hull, direction);
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#endif
