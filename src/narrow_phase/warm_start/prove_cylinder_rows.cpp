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

/// How many numbers the second corner of an edge stands behind the first.
constexpr std::ptrdiff_t kNextEnd = sizeof(ConvexWarmStart::Ends) / sizeof(double);

/// Three numbers `from` behind where a row points to. A fourth is read with them.
HWY_INLINE Vector3 pointsAt(const Points& points, std::ptrdiff_t from, const RowLanes& lanes) {
  const FourNumbers p =
      turnRows([&](std::size_t lane) HWY_ATTR { return points[lanes.row(lane)] + from; });
  return {p.at[0], p.at[1], p.at[2]};
}

/// A corner of the other core as the cylinder sees it.
HWY_INLINE Vector3 seen(const Vector3& corner, const LaneCylinderPair& pair) {
  return into(pair.cylinder.axes, out(pair.other.axes, corner) + pair.between);
}

struct FootOfCorner {
  static HWY_INLINE LaneFoot find(const LaneCylinderPair& pair, const RowLanes& lanes,
                                  CylinderRows& rows, Truth& is_found) {
    const Vector3 point = seen(pointsAt(rows.last_on_other, 0, lanes), pair);
    is_found = hn::Eq(point.x, point.x);
    return footOf(point, pair.size);
  }
};

struct FootInEdge {
  static HWY_INLINE LaneFoot find(const LaneCylinderPair& pair, const RowLanes& lanes,
                                  CylinderRows& rows, Truth& is_found) {
    const Vector3 first = pointsAt(rows.last_on_other, 0, lanes);
    const Vector3 way = pointsAt(rows.last_on_other, kNextEnd, lanes) - first;
    const Vector3 from = seen(first, pair);
    const Vector3 edge = into(pair.cylinder.axes, out(pair.other.axes, way));
    const Vector3 last = pointsAt(rows.last_on_cylinder, 0, lanes);
    Number share = within(0.0, 1.0, hn::Div(dot(edge, last - from), dot(edge, edge)));
    const LaneFoot foot = footOfEdge(from, edge, pair.size, share);
    is_found = hn::And(hn::Gt(share, zero()), hn::Lt(share, number(1.0)));
    return foot;
  }
};

struct FootInRim {
  static HWY_INLINE LaneFoot find(const LaneCylinderPair& pair, const RowLanes& lanes,
                                  CylinderRows& rows, Truth& is_found) {
    const std::size_t row = lanes.first;
    const Number radius = load(foot::radius_of_other, row, rows);
    const Number half_length = load(foot::half_length_of_other, row, rows);
    const Vector3 last = pointsAt(rows.last_on_other, 0, lanes);
    const Number height = hn::CopySign(half_length, last.z);
    const Axes& axes = pair.other.axes;
    const LaneRim rim{into(pair.cylinder.axes, along(pair.between, height, axes.z)),
                      scaled(radius, into(pair.cylinder.axes, axes.x)),
                      scaled(radius, into(pair.cylinder.axes, axes.y))};
    const Number per_length =
        hn::Div(number(1.0), hn::Sqrt(hn::Add(hn::Mul(last.x, last.x), hn::Mul(last.y, last.y))));
    LaneTurn turn{hn::Mul(per_length, last.x), hn::Mul(per_length, last.y)};
    const LaneFoot foot = footOfRim(rim, pair.size, turn);
    is_found = hn::Eq(turn.x, turn.x);
    store({hn::Mul(radius, turn.x), hn::Mul(radius, turn.y), height}, foot::on_other, row, rows);
    return foot;
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
  pair.size = {load(foot::radius, row, rows), load(foot::half_length, row, rows)};
  Truth is_found;
  const LaneFoot foot = Feature::find(pair, lanes, rows, is_found);
  const Number distance = norm(foot.away);
  const Number size = hn::Add(load(foot::size, row, rows), sumOf(absolute(pair.between)));
  const Truth is_apart = hn::And(is_found, hn::Gt(distance, touchingDistanceOf(size)));
  const Vector3 in_cylinder = scaled(hn::Div(number(1.0), distance), foot.away);
  const Vector3 normal = out(pair.cylinder.axes, in_cylinder);
  const LaneReach of_cylinder = reachAlong(in_cylinder, pair.size);
  store(distanceWhere(is_apart, distance), foot::distance, row, rows);
  store(foot.on_cylinder, foot::on_cylinder, row, rows);
  store(pair.cylinder.origin + out(pair.cylinder.axes, foot.on_cylinder), foot::point, row, rows);
  store(normal, foot::normal, row, rows);
  store(size, foot::size, row, rows);
  store(negated(into(pair.other.axes, normal)), foot::direction_in_other, row, rows);
  store(hn::Sub(dot(normal, pair.between), of_cylinder.reach), foot::gap, row, rows);
  store(hn::IfThenElseZero(of_cylinder.may_be_level, number(1.0)), foot::may_be_level, row, rows);
}

HWY_INLINE void findReachesOfRims(CylinderRows& rows) {
  for (std::size_t row = 0; row < rows.count; row += hn::Lanes(Lanes())) {
    const Vector3 direction{load(foot::direction_in_other, row, rows),
                            load(foot::direction_in_other + 1, row, rows),
                            load(foot::direction_in_other + 2, row, rows)};
    const CylinderLanes cylinder{load(foot::radius_of_other, row, rows),
                                 load(foot::half_length_of_other, row, rows)};
    const LaneReach of_other = reachAlong(direction, cylinder);
    const Number level = load(foot::may_be_level, row, rows);
    store(of_other.reach, foot::reach_of_other, row, rows);
    store(hn::IfThenElseZero(of_other.may_be_level, level), foot::may_be_level, row, rows);
  }
}

HWY_INLINE bool isPoint(const ProofSide& side) {
  const std::array<double, 3>& half = side.half_extents;
  return side.hull == nullptr && half[0] == 0.0 && half[1] == 0.0 && half[2] == 0.0;
}

/// Pair after pair, as each has vertices of its own.
HWY_INLINE void findReaches(CylinderRows& rows) {
  for (std::size_t row = 0; row < rows.count; ++row) {
    ProofSide& side = rows.other[row];
    const ExtremeFeature of_other =
        extremeOfSide(side, vectorAt(foot::direction_in_other, row, rows));
    side.vertex = of_other.vertex;
    rows.at[foot::reach_of_other][row] = of_other.reach;
    const bool may_be_level = of_other.may_be_level && !isPoint(side);
    rows.at[foot::may_be_level][row] = may_be_level ? rows.at[foot::may_be_level][row] : 0.0;
  }
}

/// Keeps the distances that the support planes prove.
HWY_INLINE void keepProvenFeet(std::size_t row, CylinderRows& rows) {
  const Number distance = load(foot::distance, row, rows);
  const Number gap = hn::Sub(load(foot::gap, row, rows), load(foot::reach_of_other, row, rows));
  const Number tolerance = hn::Mul(number(smoothTolerance(1.0)), load(foot::size, row, rows));
  const Truth meet = hn::Le(hn::Abs(hn::Sub(distance, gap)), tolerance);
  const Truth is_level = hn::Gt(load(foot::may_be_level, row, rows), zero());
  store(distanceWhere(hn::AndNot(is_level, meet), distance), foot::distance, row, rows);
}

template <class Feature>
HWY_INLINE void placeAll(CylinderRows& rows) {
  for (std::size_t row = 0; row < rows.count; row += hn::Lanes(Lanes())) {
    placeLanes<Feature>(row, rows);
  }
}

void proveFeet(FollowedFeature followed, CylinderRows& rows) {
  if (followed == FollowedFeature::rim) {
    placeAll<FootInRim>(rows);
    findReachesOfRims(rows);
  } else {
    followed == FollowedFeature::corner ? placeAll<FootOfCorner>(rows) : placeAll<FootInEdge>(rows);
    findReaches(rows);
  }
  for (std::size_t row = 0; row < rows.count; row += hn::Lanes(Lanes())) {
    keepProvenFeet(row, rows);
  }
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace collision_monitor {
namespace {

HWY_EXPORT(proveFeet);

}  // namespace

void proveCylinderRows(FollowedFeature followed, CylinderRows& rows) noexcept {
  // Rows behind the last one that share its vector are read, too.
  const auto last =
      followed == FollowedFeature::rim ? foot::half_length_of_other : foot::half_length;
  for (std::size_t column = foot::size; column <= last; ++column) {
    auto& values = rows.at[column];
    std::fill(values.begin() + rows.count, values.end(), values[rows.count - 1]);
  }
  auto& reaches = rows.at[foot::reach_of_other];
  std::fill(reaches.begin() + rows.count, reaches.end(), 0.0);
  HWY_DYNAMIC_DISPATCH(proveFeet)(followed, rows);
}

}  // namespace collision_monitor
#endif
