// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause

// The point of a corner, edge or face of the difference of two cores that is nearest to the origin,
// one pair per lane: nearestOfSimplex of simplex.h, in the same order to the last bit.
#if defined(COLLISION_MONITOR_NEAREST_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COLLISION_MONITOR_NEAREST_LANES_INL_H_
#undef COLLISION_MONITOR_NEAREST_LANES_INL_H_
#else
#define COLLISION_MONITOR_NEAREST_LANES_INL_H_
#endif

#include "geometry/lanes/lanes-inl.h"
#include "narrow_phase/gjk/simplex.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

/// Two corners from A's origin, in world axes, as PlacedCorners.
struct LaneCorners {
  Vector3 on_a, difference;
};

/// As NearestOnSimplex, with the point of A in the world. Means nothing if the point is not inside.
struct LaneNearest {
  Truth is_inside;
  Vector3 point, outward, on_a;
};

HWY_INLINE LaneNearest nearestOfSimplex(const Vector3& origin_of_a, const LaneCorners& p) {
  const Truth is_number = hn::Eq(p.difference.x, p.difference.x);
  return {is_number, p.difference, p.difference, origin_of_a + p.on_a};
}

HWY_INLINE LaneNearest nearestOfSimplex(const Vector3& origin_of_a, const LaneCorners& p,
                                        const LaneCorners& q) {
  const Vector3 edge = q.difference - p.difference;
  const Number length_squared = dot(edge, edge);
  const Number on_edge = hn::Neg(dot(p.difference, edge));
  const Truth is_inside = hn::And(hn::Gt(on_edge, zero()), hn::Lt(on_edge, length_squared));
  const Number share = hn::Div(on_edge, length_squared);
  const Vector3 point = along(p.difference, share, edge);
  const Truth is_near = hn::Lt(dot(point, point), length_squared);
  const Vector3 sharp = point - scaled(hn::Div(dot(point, edge), length_squared), edge);
  const Vector3 on_p = along(origin_of_a, hn::Sub(number(1.0), share), p.on_a);
  return {is_inside, point, select(is_near, sharp, point), along(on_p, share, q.on_a)};
}

HWY_INLINE LaneNearest nearestOfSimplex(const Vector3& origin_of_a, const LaneCorners& p,
                                        const LaneCorners& q, const LaneCorners& r) {
  const Vector3 first = q.difference - p.difference;
  const Vector3 second = r.difference - p.difference;
  const Vector3 normal = cross(first, second);
  const Number squared = dot(normal, normal);
  const Number of_second = hn::Neg(dot(cross(first, p.difference), normal));
  const Number of_first = hn::Neg(dot(cross(p.difference, second), normal));
  const Number longest = hn::Max(dot(first, first), dot(second, second));
  const Truth is_fat =
      hn::Gt(squared, hn::Mul(hn::Mul(number(kLeastSineSquared), longest), longest));
  const Truth is_over = hn::And(hn::And(hn::Gt(of_first, zero()), hn::Gt(of_second, zero())),
                                hn::Lt(hn::Add(of_first, of_second), squared));
  const Number u = hn::Div(of_first, squared);
  const Number v = hn::Div(of_second, squared);
  const Vector3 point = along(along(p.difference, u, first), v, second);
  const Truth is_near = hn::Lt(hn::Mul(dot(point, point), longest), squared);
  const Vector3 on_p = along(origin_of_a, hn::Sub(hn::Sub(number(1.0), u), v), p.on_a);
  return {hn::And(is_fat, is_over), point, select(is_near, normal, point),
          along(along(on_p, u, q.on_a), v, r.on_a)};
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#endif
