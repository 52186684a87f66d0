// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause

// The best separating axis and the contact along it, in lanes: separating_axes.cpp and
// axis_contact.cpp for pairs in general position.
#if defined(COLLISION_MONITOR_LANES_BOX_CONTACT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COLLISION_MONITOR_LANES_BOX_CONTACT_INL_H_
#undef COLLISION_MONITOR_LANES_BOX_CONTACT_INL_H_
#else
#define COLLISION_MONITOR_LANES_BOX_CONTACT_INL_H_
#endif

#include <array>

#include "narrow_phase/simd/lanes_points-inl.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

/// BoxPair of box_pair.h: two boxes, or a box and a segment (then only B's z counts), in the frame
/// of box A. `b_axes` are B's axes.
struct BoxPairLanes {
  Axes b_axes;
  Vector3 center_of_b;
  Vector3 half_a;
  Vector3 half_b;
  Number tolerance;
};

HWY_INLINE Number toleranceInLanes(const Vector3& half_a, const Vector3& half_b,
                                   const Vector3& center) {
  const Number sum = hn::Add(hn::Add(sumOf(half_a), sumOf(half_b)), sumOf(absolute(center)));
  return hn::Mul(number(4e-15), sum);
}

/// The axis of the largest gap so far. Gaps along edges are numerator / sine. They are compared as
/// signed squares, so that one root and one quotient suffice for all.
struct BestAxis {
  Number numerator, signed_square, sine_squared;
  Number of_a;  ///< 1, 2 or 3: the axis of A that takes part; 0: none
  Number of_b;  ///< the same for B
};

HWY_INLINE Number gapAlong(const BestAxis& best) {
  return hn::Div(best.numerator, hn::Sqrt(best.sine_squared));
}

HWY_INLINE void consider(Number numerator, Number sine_squared, Number of_a, Number of_b,
                         BestAxis& best) {
  const Number square = hn::Mul(numerator, hn::Abs(numerator));
  const Truth is_better =
      hn::And(hn::Gt(hn::Mul(square, best.sine_squared), hn::Mul(best.signed_square, sine_squared)),
              hn::Gt(sine_squared, number(1e-30)));
  best.numerator = hn::IfThenElse(is_better, numerator, best.numerator);
  best.signed_square = hn::IfThenElse(is_better, square, best.signed_square);
  best.sine_squared = hn::IfThenElse(is_better, sine_squared, best.sine_squared);
  best.of_a = hn::IfThenElse(is_better, of_a, best.of_a);
  best.of_b = hn::IfThenElse(is_better, of_b, best.of_b);
}

HWY_INLINE Number axisOf(const LargestOfThree& largest) {
  return hn::IfThenElse(largest.is_z, number(3.0),
                        hn::IfThenElse(largest.is_y, number(2.0), number(1.0)));
}

/// 1 at that axis, 0 elsewhere.
HWY_INLINE Vector3 unitVector(Number axis) {
  return {hn::IfThenElseZero(hn::Eq(axis, number(1.0)), number(1.0)),
          hn::IfThenElseZero(hn::Eq(axis, number(2.0)), number(1.0)),
          hn::IfThenElseZero(hn::Eq(axis, number(3.0)), number(1.0))};
}

/// Considers axis i of A crossed with every axis of B (or its z alone). p and q follow i in turn:
/// the arguments are these components of B's axes, of B's center and of A's half extents.
template <bool kBIsSegment>
HWY_INLINE void considerEdges(double i, const Vector3& f_p, const Vector3& f_q, Number c_p,
                              Number c_q, Number half_p, Number half_q, const Vector3& half_b,
                              BestAxis& best) {
  const auto gap = [&](Number p, Number q, Number reach_b) HWY_ATTR {
    const Number reach =
        hn::Add(hn::Add(hn::Mul(half_p, hn::Abs(q)), hn::Mul(half_q, hn::Abs(p))), reach_b);
    return hn::Sub(hn::Abs(hn::Sub(hn::Mul(c_q, p), hn::Mul(c_p, q))), reach);
  };
  const auto sineSquared = [&](Number p, Number q)
                               HWY_ATTR { return hn::Add(hn::Mul(p, p), hn::Mul(q, q)); };
  if constexpr (kBIsSegment) {
    consider(gap(f_p.z, f_q.z, zero()), sineSquared(f_p.z, f_q.z), number(i), number(3.0), best);
  } else {
    const Vector3 minors = absolute(cross(f_p, f_q));  // of the axes 1 2, 2 0 and 0 1
    const auto reach = [](Number h1, Number m1, Number h2, Number m2)
                           HWY_ATTR { return hn::Add(hn::Mul(h1, m1), hn::Mul(h2, m2)); };
    consider(gap(f_p.x, f_q.x, reach(half_b.y, minors.z, half_b.z, minors.y)),
             sineSquared(f_p.x, f_q.x), number(i), number(1.0), best);
    consider(gap(f_p.y, f_q.y, reach(half_b.x, minors.z, half_b.z, minors.x)),
             sineSquared(f_p.y, f_q.y), number(i), number(2.0), best);
    consider(gap(f_p.z, f_q.z, reach(half_b.x, minors.y, half_b.y, minors.x)),
             sineSquared(f_p.z, f_q.z), number(i), number(3.0), best);
  }
}

/// The best of the axes across faces, which separate most boxes.
template <bool kBIsSegment>
HWY_INLINE BestAxis bestOfFaces(const BoxPairLanes& pair) {
  const Axes& f = pair.b_axes;
  const Vector3& c = pair.center_of_b;
  Vector3 reach_a = along(pair.half_a, pair.half_b.z, absolute(f.z));
  if constexpr (!kBIsSegment) {
    reach_a = along(along(reach_a, pair.half_b.x, absolute(f.x)), pair.half_b.y, absolute(f.y));
  }
  const LargestOfThree of_a = largestOf(absolute(c) - reach_a);
  BestAxis best{of_a.value, hn::Mul(of_a.value, hn::Abs(of_a.value)), number(1.0), axisOf(of_a),
                zero()};
  if constexpr (!kBIsSegment) {
    const Vector3 reach_b{hn::Add(pair.half_b.x, dot(absolute(f.x), pair.half_a)),
                          hn::Add(pair.half_b.y, dot(absolute(f.y), pair.half_a)),
                          hn::Add(pair.half_b.z, dot(absolute(f.z), pair.half_a))};
    const LargestOfThree of_b = largestOf(absolute(into(f, c)) - reach_b);
    consider(of_b.value, number(1.0), zero(), axisOf(of_b), best);
  }
  return best;
}

/// Considers the axes across edges, too.
template <bool kBIsSegment>
HWY_INLINE void considerAllEdges(const BoxPairLanes& pair, BestAxis& best) {
  const Axes& f = pair.b_axes;
  const Vector3& c = pair.center_of_b;
  const Vector3 rows[3] = {{f.x.x, f.y.x, f.z.x}, {f.x.y, f.y.y, f.z.y}, {f.x.z, f.y.z, f.z.z}};
  const Vector3& half = pair.half_a;
  considerEdges<kBIsSegment>(1.0, rows[1], rows[2], c.y, c.z, half.y, half.z, pair.half_b, best);
  considerEdges<kBIsSegment>(2.0, rows[2], rows[0], c.z, c.x, half.z, half.x, pair.half_b, best);
  considerEdges<kBIsSegment>(3.0, rows[0], rows[1], c.x, c.y, half.x, half.y, pair.half_b, best);
}

template <bool kBIsSegment>
HWY_INLINE BestAxis bestAxis(const BoxPairLanes& pair) {
  BestAxis best = bestOfFaces<kBIsSegment>(pair);
  considerAllEdges<kBIsSegment>(pair, best);
  return best;
}

/// The corner of a box that is farthest in `direction`. Frames: the box's.
HWY_INLINE Vector3 cornerTowards(const Vector3& half, const Vector3& direction) {
  return {hn::CopySign(half.x, direction.x), hn::CopySign(half.y, direction.y),
          hn::CopySign(half.z, direction.z)};
}

/// True if a point lies in the face of a box that `axis` crosses.
HWY_INLINE Truth liesInFace(const Vector3& point, const Vector3& half, const Vector3& axis,
                            Number slack) {
  const Vector3 beyond = absolute(point) - half;
  const Truth one = hn::Gt(axis.x, zero());
  const Truth two = hn::Gt(axis.y, zero());
  const Truth three = hn::Gt(axis.z, zero());
  return hn::And(
      hn::And(hn::Or(one, hn::Le(beyond.x, slack)), hn::Or(two, hn::Le(beyond.y, slack))),
      hn::Or(three, hn::Le(beyond.z, slack)));
}

/// v with 0 where `axis` is 1.
HWY_INLINE Vector3 without(const Vector3& axis, const Vector3& v) {
  return {hn::IfThenZeroElse(hn::Gt(axis.x, zero()), v.x),
          hn::IfThenZeroElse(hn::Gt(axis.y, zero()), v.y),
          hn::IfThenZeroElse(hn::Gt(axis.z, zero()), v.z)};
}

/// Points that realise the largest gap, in A's frame. `holds`: they lie on their features.
struct AxisContact {
  Number gap;
  Vector3 point_on_a;
  Vector3 normal;
  Truth holds;
};

/// Where an axis of B is parallel to a face of A, the points may lie on no feature.
HWY_INLINE AxisContact contactAlong(const BoxPairLanes& pair, const BestAxis& best) {
  const Number sine = hn::Sqrt(best.sine_squared);
  const Number gap = hn::Div(best.numerator, sine);
  const Truth has_a = hn::Gt(best.of_a, zero());
  const Truth has_b = hn::Gt(best.of_b, zero());
  const Truth is_edges = hn::And(has_a, has_b);
  const Vector3 of_a = unitVector(best.of_a);
  const Vector3 of_b = unitVector(best.of_b);
  const Vector3 axis_of_b = out(pair.b_axes, of_b);
  Vector3 normal = select(is_edges, scaled(hn::Div(number(1.0), sine), cross(of_a, axis_of_b)),
                          select(has_a, of_a, axis_of_b));
  normal = scaled(signOf(dot(normal, pair.center_of_b)), normal);

  const Vector3 corner_of_a = cornerTowards(pair.half_a, normal);
  const Vector3 normal_in_b = into(pair.b_axes, normal);
  const Vector3 corner_in_b = negated(cornerTowards(pair.half_b, normal_in_b));
  // Edges: through the corners, along the crossed axes.
  const Vector3 middle_a = without(of_a, corner_of_a);
  const Vector3 middle_b = pair.center_of_b + out(pair.b_axes, without(of_b, corner_in_b));
  const LaneParameters closest = closestInLanes(middle_b - middle_a, of_a, dot(of_a, pair.half_a),
                                                axis_of_b, dot(of_b, pair.half_b), everywhere());
  const Vector3 on_edge_a = along(middle_a, closest.on_a, of_a);
  const Vector3 on_edge_b = along(middle_b, closest.on_b, axis_of_b);
  const Number defect = norm(along(on_edge_a, gap, normal) - on_edge_b);

  const Vector3 corner_of_b = pair.center_of_b + out(pair.b_axes, corner_in_b);
  const Vector3 on_face_a = along(corner_of_b, hn::Neg(gap), normal);
  const Truth in_face_a = liesInFace(on_face_a, pair.half_a, of_a, pair.tolerance);
  const Vector3 seen_from_b = into(pair.b_axes, corner_of_a - pair.center_of_b);
  const Truth in_face_b = liesInFace(seen_from_b, pair.half_b, of_b, pair.tolerance);

  const Truth holds = hn::Or(hn::And(is_edges, hn::Le(defect, pair.tolerance)),
                             hn::Or(hn::And(hn::AndNot(has_b, has_a), in_face_a),
                                    hn::And(hn::AndNot(has_a, has_b), in_face_b)));
  const Vector3 point = select(is_edges, on_edge_a, select(has_a, on_face_a, corner_of_a));
  return {gap, point, normal, holds};
}

/// True if no component of a unit vector is so small that it could be zero.
HWY_INLINE Truth isSkew(const Vector3& axis) {
  const Vector3 v = absolute(axis);
  return hn::Gt(hn::Min(hn::Min(v.x, v.y), v.z), number(kParallel));
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#endif
