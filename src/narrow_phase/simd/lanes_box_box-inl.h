// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause

// Two boxes in lanes, as distance_box_box.cpp measures them. If axes are parallel, the lanes find
// the distance but not always the points; distance_box_box.cpp then finds the points.
#if defined(COLLISION_MONITOR_LANES_BOX_BOX_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COLLISION_MONITOR_LANES_BOX_BOX_INL_H_
#undef COLLISION_MONITOR_LANES_BOX_BOX_INL_H_
#else
#define COLLISION_MONITOR_LANES_BOX_BOX_INL_H_
#endif

#include "narrow_phase/simd/lanes_box_contact-inl.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

/// [m] A distance counts as proven if the distance of the points and the gap along a plane differ
/// by no more than this: half of the error that a distance may have.
constexpr double kProofAllowance = 5e-13;

/// [m] A nearest corner that is farther away than the best gap by more than this is the only
/// nearest point: if a face or an edge were as near, the gap along its axis would be the distance.
constexpr double kAlone = 1e-9;

/// Of eight corners, the one nearest to a box at the origin.
struct CornerLanes {
  Number distance_squared;
  Vector3 corner;
};

HWY_INLINE void considerCorner(const Vector3& corner, const Vector3& half, CornerLanes& nearest) {
  const Number distance_squared = outsideSquared(absolute(corner) - half);
  const Truth is_nearer = hn::Lt(distance_squared, nearest.distance_squared);
  nearest.distance_squared = hn::IfThenElse(is_nearer, distance_squared, nearest.distance_squared);
  nearest.corner = select(is_nearer, corner, nearest.corner);
}

/// Tries the corners of the box with this center and these half axes.
HWY_INLINE CornerLanes nearestCorner(const Vector3& center, const Axes& sides,
                                     const Vector3& half) {
  CornerLanes nearest{number(std::numeric_limits<double>::infinity()), center};
  for (const Vector3& x : {center - sides.x, center + sides.x}) {
    for (const Vector3& y : {x - sides.y, x + sides.y}) {
      considerCorner(y - sides.z, half, nearest);
      considerCorner(y + sides.z, half, nearest);
    }
  }
  return nearest;
}

/// Turns columns into rows.
HWY_INLINE Axes transposed(const Axes& axes) {
  return {{axes.x.x, axes.y.x, axes.z.x},
          {axes.x.y, axes.y.y, axes.z.y},
          {axes.x.z, axes.y.z, axes.z.z}};
}

HWY_INLINE Axes scaledAxes(const Vector3& s, const Axes& axes) {
  return {scaled(s.x, axes.x), scaled(s.y, axes.y), scaled(s.z, axes.z)};
}

/// Gap of the boxes along a unit direction from A to B: a lower bound of their distance.
HWY_INLINE Number gapAlong(const BoxPairLanes& pair, const Vector3& direction) {
  const Number reach_a = dot(absolute(direction), pair.half_a);
  const Number reach_b = dot(absolute(into(pair.b_axes, direction)), pair.half_b);
  return hn::Sub(hn::Sub(dot(direction, pair.center_of_b), reach_a), reach_b);
}

/// Answer for boxes that are apart with a corner nearest. Frames: A's. Sure if a plane between the
/// points proves it: if axes tie, a face or an edge may be nearest after all.
HWY_INLINE CoreAnswer cornerDistance(const BoxPairLanes& pair) {
  const CornerLanes of_b =
      nearestCorner(pair.center_of_b, scaledAxes(pair.half_b, pair.b_axes), pair.half_a);
  const Vector3 center_of_a = negated(into(pair.b_axes, pair.center_of_b));
  const CornerLanes of_a =
      nearestCorner(center_of_a, scaledAxes(pair.half_a, transposed(pair.b_axes)), pair.half_b);
  const Vector3 on_a = clamped(pair.half_a, of_b.corner);
  const Vector3 between_of_b = of_b.corner - on_a;
  const Vector3 between_of_a = out(pair.b_axes, clamped(pair.half_b, of_a.corner) - of_a.corner);
  const Truth is_of_b = hn::Le(of_b.distance_squared, of_a.distance_squared);
  const Vector3 between = select(is_of_b, between_of_b, between_of_a);
  const Vector3 corner_of_a = pair.center_of_b + out(pair.b_axes, of_a.corner);
  const Number distance = norm(between);
  const Vector3 normal = scaled(hn::Div(number(1.0), distance), between);
  const Truth is_proven =
      hn::Ge(gapAlong(pair, normal), hn::Sub(distance, number(kProofAllowance)));
  return {sureWhere(is_proven, distance), select(is_of_b, on_a, corner_of_a), normal};
}

HWY_INLINE BoxPairLanes boxPairInLanes(const BoxCore& a, const BoxCore& b) {
  const Vector3 center = into(a.axes, b.center - a.center);
  return {{into(a.axes, b.axes.x), into(a.axes, b.axes.y), into(a.axes, b.axes.z)},
          center,
          a.half_extents,
          b.half_extents,
          toleranceInLanes(a.half_extents, b.half_extents, center)};
}

HWY_INLINE Truth isSkew(const BoxPairLanes& pair) {
  return hn::And(hn::And(isSkew(pair.b_axes.x), isSkew(pair.b_axes.y)), isSkew(pair.b_axes.z));
}

/// True if an edge of A is parallel to one of B, and both are perpendicular to the direction: the
/// nearest points are then not unique.
HWY_INLINE Truth hasEdgeAcross(const BoxPairLanes& pair, const Vector3& direction) {
  const auto isSmall = [](Number x) HWY_ATTR { return hn::Le(hn::Abs(x), number(kParallel)); };
  Truth has_edge = hn::Not(everywhere());
  for (const Vector3& axis : {pair.b_axes.x, pair.b_axes.y, pair.b_axes.z}) {
    const Truth x = isSmall(axis.x);
    const Truth y = isSmall(axis.y);
    const Truth z = isSmall(axis.z);
    has_edge = hn::Or(has_edge, hn::And(hn::And(y, z), isSmall(direction.x)));
    has_edge = hn::Or(has_edge, hn::And(hn::And(z, x), isSmall(direction.y)));
    has_edge = hn::Or(has_edge, hn::And(hn::And(x, y), isSmall(direction.z)));
  }
  return has_edge;
}

/// An answer, and in which lanes no other points are as near.
struct UniqueAnswer {
  CoreAnswer cores;
  Truth is_unique;
};

/// In A's frame. Its distance is proven where it is sure: by points on both boxes, and by a plane
/// between them.
HWY_INLINE UniqueAnswer answerAlong(const BoxPairLanes& pair, const BestAxis& best) {
  const AxisContact contact = contactAlong(pair, best);
  CoreAnswer cores{contact.gap, contact.point_on_a, contact.normal};
  const Truth by_corner = hn::AndNot(contact.holds, hn::Gt(contact.gap, number(kTouching)));
  Truth is_unique = isSkew(pair);
  if (!hn::AllFalse(Lanes(), by_corner)) {
    const CoreAnswer corner = cornerDistance(pair);
    const Truth is_alone = hn::Gt(corner.distance, hn::Add(contact.gap, number(kAlone)));
    is_unique = hn::Or(
        is_unique, hn::AndNot(hasEdgeAcross(pair, corner.normal), hn::And(by_corner, is_alone)));
    cores = {hn::IfThenElse(by_corner, corner.distance, cores.distance),
             select(by_corner, corner.point_on_a, cores.point_on_a),
             select(by_corner, corner.normal, cores.normal)};
  }
  cores.distance = sureWhere(hn::Or(contact.holds, by_corner), cores.distance);
  return {cores, is_unique};
}

HWY_INLINE CoreAnswer coreDistance(const BoxCore& a, const BoxCore& b) {
  const BoxPairLanes pair = boxPairInLanes(a, b);
  const auto [cores, is_unique] = answerAlong(pair, bestAxis<false>(pair));
  return {sureWhere(is_unique, cores.distance), a.center + out(a.axes, cores.point_on_a),
          out(a.axes, cores.normal)};
}

/// False if an axis across a face parts the shapes by more than `reach`.
HWY_INLINE Truth mayBeWithin(const BoxCore& a, const BoxCore& b, Number reach) {
  const BoxPairLanes pair = boxPairInLanes(a, b);
  const Number of_cores = hn::Add(hn::Add(reach, a.radius), b.radius);
  const Number apart = hn::Max(hn::Add(of_cores, pair.tolerance), zero());
  return hn::Not(hn::Gt(bestOfFaces<false>(pair).numerator, apart));
}

/// The axis that parts two boxes best, or that gives their depth. Lanes whose axis proves them
/// beyond `reach` no longer count.
HWY_INLINE BestAxis axisWithin(const BoxPairLanes& pair, Number reach, Truth& counts) {
  const Number apart = hn::Max(hn::Add(reach, pair.tolerance), zero());
  BestAxis best = bestOfFaces<false>(pair);
  counts = hn::AndNot(hn::Gt(best.numerator, apart), counts);
  if (!hn::AllFalse(Lanes(), counts)) {
    considerAllEdges<false>(pair, best);
    // If the gap is positive, the numerator is at most the gap.
    counts = hn::AndNot(hn::Gt(best.numerator, apart), counts);
  }
  return best;
}

/// If boxes overlap, the best axis gives the depth, and no point needs to prove it. The nearest
/// points need not be unique.
HWY_INLINE Number separationWithin(const BoxCore& a, const BoxCore& b, Number reach,
                                   Truth& counts) {
  const BoxPairLanes pair = boxPairInLanes(a, b);
  const BestAxis best = axisWithin(pair, reach, counts);
  if (hn::AllFalse(Lanes(), counts)) {
    return best.numerator;
  }
  const Number gap = gapAlong(best);
  const Truth is_depth = hn::Le(gap, zero());
  if (hn::AllFalse(Lanes(), hn::AndNot(is_depth, counts))) {
    return gap;
  }
  return hn::IfThenElse(is_depth, gap, answerAlong(pair, best).cores.distance);
}

/// A lower bound of separationWithin; it takes no search for points.
HWY_INLINE Number boundWithin(const BoxCore& a, const BoxCore& b, Number reach, Truth& counts) {
  const Number of_cores = hn::Add(hn::Add(reach, a.radius), b.radius);
  const BestAxis best = axisWithin(boxPairInLanes(a, b), of_cores, counts);
  return hn::Sub(hn::Sub(gapAlong(best), a.radius), b.radius);
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#endif
