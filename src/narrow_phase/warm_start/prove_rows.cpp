// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/lanes/lane_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "narrow_phase/warm_start/prove_rows.cpp"
#include "hwy/foreach_target.h"
// The order matters: Highway first includes this file once for each target.
#include <algorithm>

#include "narrow_phase/warm_start/nearest_lanes-inl.h"
#include "narrow_phase/warm_start/proof_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

/// ConvexWarmStart::ends of rows.
struct LaneEnds {
  const std::array<const double*, kProofRows>& of;
  RowLanes lanes;
};

struct LanePair {
  PlacedAxes a, b;
  Vector3 between;
};

/// The corners `i` of the last search at the current poses, as place() of support_plane.h.
HWY_INLINE LaneCorners cornersAt(std::size_t i, const LanePair& pair, const LaneEnds& ends) {
  const auto four = [&](std::size_t from) HWY_ATTR {
    return turnRows([&](std::size_t lane)
                        HWY_ATTR { return ends.of[ends.lanes.row(lane)] + 6 * i + from; });
  };
  const FourNumbers head = four(0);
  const FourNumbers tail = four(2);
  const Vector3 on_a = out(pair.a.axes, {head.at[0], head.at[1], head.at[2]});
  const Vector3 on_b = out(pair.b.axes, {tail.at[1], tail.at[2], tail.at[3]});
  return {on_a, on_b + (pair.between - on_a)};
}

template <std::size_t kCorners>
HWY_INLINE LaneNearest nearestOf(const LanePair& pair, const LaneEnds& ends) {
  const LaneCorners first = cornersAt(0, pair, ends);
  if constexpr (kCorners == 1) {
    return nearestOfSimplex(pair.a.origin, first);
  } else if constexpr (kCorners == 2) {
    return nearestOfSimplex(pair.a.origin, first, cornersAt(1, pair, ends));
  } else {
    return nearestOfSimplex(pair.a.origin, first, cornersAt(1, pair, ends),
                            cornersAt(2, pair, ends));
  }
}

/// Finds distance, point and normal from the corners, as normalOf and stepToNearest.
template <std::size_t kCorners>
HWY_INLINE void placeLanes(std::size_t row, ProofRows& rows) {
  const RowLanes lanes{rows.count, row};
  LanePair pair{placeOf(rows.a, lanes), placeOf(rows.b, lanes), {}};
  pair.between = pair.b.origin - pair.a.origin;
  const LaneNearest nearest = nearestOf<kCorners>(pair, {rows.ends, lanes});
  const Number sense = signOf(dot(nearest.outward, nearest.point));
  const Vector3 normal = scaled(hn::Div(sense, norm(nearest.outward)), nearest.outward);
  const Number distance = dot(normal, nearest.point);
  const Number size = hn::Add(load(proof::size, row, rows), sumOf(absolute(pair.between)));
  const Truth is_apart = hn::And(nearest.is_inside, hn::Gt(distance, touchingDistanceOf(size)));
  store(distanceWhere(is_apart, distance), proof::distance, row, rows);
  store(nearest.on_a, proof::point_on_a, row, rows);
  store(normal, proof::normal, row, rows);
  store(size, proof::size, row, rows);
  store(dot(normal, pair.between), proof::between, row, rows);
  store(into(pair.a.axes, normal), proof::direction_in_a, row, rows);
  store(negated(into(pair.b.axes, normal)), proof::direction_in_b, row, rows);
}

/// Finds the support planes. Works pair by pair, because each has vertices of its own.
HWY_INLINE void findReaches(ProofRows& rows) {
  for (std::size_t row = 0; row < rows.count; ++row) {
    const ExtremeFeature of_a =
        extremeOfSide(rows.a[row], vectorAt(proof::direction_in_a, row, rows));
    const ExtremeFeature of_b =
        extremeOfSide(rows.b[row], vectorAt(proof::direction_in_b, row, rows));
    rows.a[row].vertex = of_a.vertex;
    rows.b[row].vertex = of_b.vertex;
    rows.at[proof::reach_of_a][row] = of_a.reach;
    rows.at[proof::reach_of_b][row] = of_b.reach;
    rows.may_be_level[row] = of_a.may_be_level && of_b.may_be_level;
  }
}

/// Keeps the distances that the support planes prove, as meet().
HWY_INLINE void keepProven(std::size_t row, ProofRows& rows) {
  const Number distance = load(proof::distance, row, rows);
  const Number gap =
      hn::Sub(hn::Sub(load(proof::between, row, rows), load(proof::reach_of_a, row, rows)),
              load(proof::reach_of_b, row, rows));
  const Number rounding = hn::Mul(number(roundingOf(1.0)), load(proof::size, row, rows));
  const Truth meet = hn::Le(hn::Abs(hn::Sub(distance, gap)), rounding);
  store(distanceWhere(meet, distance), proof::distance, row, rows);
}

template <std::size_t kCorners>
void proveByCorners(ProofRows& rows) {
  for (std::size_t row = 0; row < rows.count; row += hn::Lanes(Lanes())) {
    placeLanes<kCorners>(row, rows);
  }
  findReaches(rows);
  for (std::size_t row = 0; row < rows.count; row += hn::Lanes(Lanes())) {
    keepProven(row, rows);
  }
}

void proveLanes(std::size_t corners, ProofRows& rows) {
  if (corners == 1) {
    proveByCorners<1>(rows);
  } else if (corners == 2) {
    proveByCorners<2>(rows);
  } else {
    proveByCorners<3>(rows);
  }
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace collision_monitor {
namespace {

HWY_EXPORT(proveLanes);

}  // namespace

void proveRows(std::size_t corners, ProofRows& rows) noexcept {
  // Rows after the last one that share its vector are read, too.
  for (const proof::Column column : {proof::size, proof::reach_of_a, proof::reach_of_b}) {
    std::fill(rows.at[column].begin() + rows.count, rows.at[column].end(), 0.0);
  }
  HWY_DYNAMIC_DISPATCH(proveLanes)(corners, rows);
}

}  // namespace collision_monitor
#endif
