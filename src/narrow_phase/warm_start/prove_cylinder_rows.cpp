// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/lanes/lane_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "narrow_phase/warm_start/prove_cylinder_rows.cpp"
#include "hwy/foreach_target.h"
// The order matters: Highway first includes this file once for each target.
#include <algorithm>

#include "narrow_phase/warm_start/cylinder_lanes-inl.h"
#include "narrow_phase/warm_start/cylinder_rows.h"
#include "narrow_phase/warm_start/proof_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

/// A cylinder and the other core of each lane.
struct LaneCylinderPair {
  PlacedAxes cylinder, other;
  Vector3 between;
  CylinderLanes size;
};

using Points = std::array<const double*, kProofRows>;

/// Numbers in memory from the first corner of an edge to the second.
constexpr std::ptrdiff_t kNextEnd = sizeof(ConvexWarmStart::Ends) / sizeof(double);

/// Reads three numbers, `from` after those that a row points to. A fourth is read with them.
HWY_INLINE Vector3 pointsAt(const Points& points, std::ptrdiff_t from, const RowLanes& lanes) {
  const FourNumbers p =
      turnRows([&](std::size_t lane) HWY_ATTR { return points[lanes.row(lane)] + from; });
  return {p.at[0], p.at[1], p.at[2]};
}

/// A corner of the other core in the cylinder's frame.
HWY_INLINE Vector3 seen(const Vector3& corner, const LaneCylinderPair& pair) {
  return into(pair.cylinder.axes, out(pair.other.axes, corner) + pair.between);
}

struct ClosestToCorner {
  static HWY_INLINE LaneClosest find(const LaneCylinderPair& pair, const RowLanes& lanes,
                                     CylinderRows& rows, Truth& is_found) {
    const Vector3 point = seen(pointsAt(rows.last_on_other, 0, lanes), pair);
    is_found = hn::Eq(point.x, point.x);
    return closestOf(point, pair.size);
  }
};

struct ClosestInEdge {
  static HWY_INLINE LaneClosest find(const LaneCylinderPair& pair, const RowLanes& lanes,
                                     CylinderRows& rows, Truth& is_found) {
    const Vector3 first = pointsAt(rows.last_on_other, 0, lanes);
    const Vector3 delta = pointsAt(rows.last_on_other, kNextEnd, lanes) - first;
    const Vector3 from = seen(first, pair);
    const Vector3 edge = into(pair.cylinder.axes, out(pair.other.axes, delta));
    const Vector3 last = pointsAt(rows.last_on_cylinder, 0, lanes);
    Number share = within(0.0, 1.0, hn::Div(dot(edge, last - from), dot(edge, edge)));
    const LaneClosest closest = closestToEdge(from, edge, pair.size, share);
    is_found = hn::And(hn::Gt(share, zero()), hn::Lt(share, number(1.0)));
    return closest;
  }
};

struct ClosestInRim {
  static HWY_INLINE LaneClosest find(const LaneCylinderPair& pair, const RowLanes& lanes,
                                     CylinderRows& rows, Truth& is_found) {
    const std::size_t row = lanes.first;
    const Number radius = load(closest::radius_of_other, row, rows);
    const Number half_length = load(closest::half_length_of_other, row, rows);
    const Vector3 last = pointsAt(rows.last_on_other, 0, lanes);
    const Number height = hn::CopySign(half_length, last.z);
    const Axes& axes = pair.other.axes;
    const LaneRim rim{into(pair.cylinder.axes, along(pair.between, height, axes.z)),
                      scaled(radius, into(pair.cylinder.axes, axes.x)),
                      scaled(radius, into(pair.cylinder.axes, axes.y))};
    const Number per_length =
        hn::Div(number(1.0), hn::Sqrt(hn::Add(hn::Mul(last.x, last.x), hn::Mul(last.y, last.y))));
    LaneTurn turn{hn::Mul(per_length, last.x), hn::Mul(per_length, last.y)};
    const LaneClosest closest = closestToRim(rim, pair.size, turn);
    is_found = hn::Eq(turn.x, turn.x);
    store({hn::Mul(radius, turn.x), hn::Mul(radius, turn.y), height}, closest::on_other, row, rows);
    return closest;
  }
};

/// How far a cylinder reaches along a unit direction in its frame, as extremeOfPrimitive.
struct LaneReach {
  Number reach;
  Truth may_be_level;
};

HWY_INLINE LaneReach reachAlong(const Vector3& direction, const CylinderLanes& cylinder) {
  const Number across =
      hn::Sqrt(hn::Add(hn::Mul(direction.x, direction.x), hn::Mul(direction.y, direction.y)));
  const Number up = hn::Abs(direction.z);
  return {hn::Add(hn::Mul(cylinder.radius, across), hn::Mul(cylinder.half_length, up)),
          hn::Le(hn::Min(across, up), number(kLevelSine))};
}

template <class Feature>
HWY_INLINE void placeLanes(std::size_t row, CylinderRows& rows) {
  const RowLanes lanes{rows.count, row};
  LaneCylinderPair pair{placeOf(rows.cylinder, lanes), placeOf(rows.other, lanes), {}, {}};
  pair.between = pair.other.origin - pair.cylinder.origin;
  pair.size = {load(closest::radius, row, rows), load(closest::half_length, row, rows)};
  Truth is_found;
  const LaneClosest closest = Feature::find(pair, lanes, rows, is_found);
  const Number distance = norm(closest.away);
  const Number size = hn::Add(load(closest::size, row, rows), sumOf(absolute(pair.between)));
  const Truth is_apart = hn::And(is_found, hn::Gt(distance, touchingDistanceOf(size)));
  const Vector3 in_cylinder = scaled(hn::Div(number(1.0), distance), closest.away);
  const Vector3 normal = out(pair.cylinder.axes, in_cylinder);
  const LaneReach of_cylinder = reachAlong(in_cylinder, pair.size);
  store(distanceWhere(is_apart, distance), closest::distance, row, rows);
  store(closest.on_cylinder, closest::on_cylinder, row, rows);
  store(pair.cylinder.origin + out(pair.cylinder.axes, closest.on_cylinder), closest::point, row,
        rows);
  store(normal, closest::normal, row, rows);
  store(size, closest::size, row, rows);
  store(negated(into(pair.other.axes, normal)), closest::direction_in_other, row, rows);
  store(hn::Sub(dot(normal, pair.between), of_cylinder.reach), closest::gap, row, rows);
  store(hn::IfThenElseZero(of_cylinder.may_be_level, number(1.0)), closest::may_be_level, row,
        rows);
}

HWY_INLINE void findReachesOfRims(CylinderRows& rows) {
  for (std::size_t row = 0; row < rows.count; row += hn::Lanes(Lanes())) {
    const Vector3 direction{load(closest::direction_in_other, row, rows),
                            load(closest::direction_in_other + 1, row, rows),
                            load(closest::direction_in_other + 2, row, rows)};
    const CylinderLanes cylinder{load(closest::radius_of_other, row, rows),
                                 load(closest::half_length_of_other, row, rows)};
    const LaneReach of_other = reachAlong(direction, cylinder);
    const Number level = load(closest::may_be_level, row, rows);
    store(of_other.reach, closest::reach_of_other, row, rows);
    store(hn::IfThenElseZero(of_other.may_be_level, level), closest::may_be_level, row, rows);
  }
}

HWY_INLINE bool isPoint(const ProofSide& side) {
  const std::array<double, 3>& half = side.half_extents;
  return side.hull == nullptr && half[0] == 0.0 && half[1] == 0.0 && half[2] == 0.0;
}

/// Works pair by pair, because each has vertices of its own.
HWY_INLINE void findReaches(CylinderRows& rows) {
  for (std::size_t row = 0; row < rows.count; ++row) {
    ProofSide& side = rows.other[row];
    const ExtremeFeature of_other =
        extremeOfSide(side, vectorAt(closest::direction_in_other, row, rows));
    side.vertex = of_other.vertex;
    rows.at[closest::reach_of_other][row] = of_other.reach;
    const bool may_be_level = of_other.may_be_level && !isPoint(side);
    rows.at[closest::may_be_level][row] = may_be_level ? rows.at[closest::may_be_level][row] : 0.0;
  }
}

/// Keeps the distances that the support planes prove.
HWY_INLINE void keepProven(std::size_t row, CylinderRows& rows) {
  const Number distance = load(closest::distance, row, rows);
  const Number gap =
      hn::Sub(load(closest::gap, row, rows), load(closest::reach_of_other, row, rows));
  const Number tolerance = hn::Mul(number(smoothTolerance(1.0)), load(closest::size, row, rows));
  const Truth meet = hn::Le(hn::Abs(hn::Sub(distance, gap)), tolerance);
  const Truth is_level = hn::Gt(load(closest::may_be_level, row, rows), zero());
  store(distanceWhere(hn::AndNot(is_level, meet), distance), closest::distance, row, rows);
}

template <class Feature>
HWY_INLINE void placeAll(CylinderRows& rows) {
  for (std::size_t row = 0; row < rows.count; row += hn::Lanes(Lanes())) {
    placeLanes<Feature>(row, rows);
  }
}

void proveClosestPoints(FollowedFeature followed, CylinderRows& rows) {
  if (followed == FollowedFeature::rim) {
    placeAll<ClosestInRim>(rows);
    findReachesOfRims(rows);
  } else {
    followed == FollowedFeature::corner ? placeAll<ClosestToCorner>(rows)
                                        : placeAll<ClosestInEdge>(rows);
    findReaches(rows);
  }
  for (std::size_t row = 0; row < rows.count; row += hn::Lanes(Lanes())) {
    keepProven(row, rows);
  }
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace collision_monitor {
namespace {

HWY_EXPORT(proveClosestPoints);

}  // namespace

void proveCylinderRows(FollowedFeature followed, CylinderRows& rows) noexcept {
  // Rows after the last one that share its vector are read, too.
  const auto last =
      followed == FollowedFeature::rim ? closest::half_length_of_other : closest::half_length;
  for (std::size_t column = closest::size; column <= last; ++column) {
    auto& values = rows.at[column];
    std::fill(values.begin() + rows.count, values.end(), values[rows.count - 1]);
  }
  auto& reaches = rows.at[closest::reach_of_other];
  std::fill(reaches.begin() + rows.count, reaches.end(), 0.0);
  HWY_DYNAMIC_DISPATCH(proveClosestPoints)(followed, rows);
}

}  // namespace collision_monitor
#endif
