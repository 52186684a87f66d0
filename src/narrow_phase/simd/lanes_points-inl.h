// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause

// Points and segments in lanes: distance_point_point.cpp, distance_point_segment.cpp,
// distance_segment_segment.cpp and distance_point_box.cpp, with selections in place of branches.
#if defined(COLLISION_MONITOR_LANES_POINTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COLLISION_MONITOR_LANES_POINTS_INL_H_
#undef COLLISION_MONITOR_LANES_POINTS_INL_H_
#else
#define COLLISION_MONITOR_LANES_POINTS_INL_H_
#endif

#include "narrow_phase/closed_form/core_distance.h"
#include "narrow_phase/simd/shape_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

/// The answer from A's closest point and the vector from there to B. Sure if that is longer than
/// `least`.
HWY_INLINE CoreAnswer answerOfSide(const Vector3& on_a, const Vector3& delta, double least) {
  const Number distance = norm(delta);
  return {sureWhere(hn::Gt(distance, number(least)), distance), on_a,
          scaled(hn::Div(number(1.0), distance), delta)};
}

HWY_INLINE CoreAnswer coreDistance(const PointCore& a, const PointCore& b) {
  return answerOfSide(a.center, b.center - a.center, kTouching);
}

HWY_INLINE CoreAnswer coreDistance(const PointCore& a, const SegmentCore& b) {
  const Number parameter = clamped(b.half_length, dot(b.direction, a.center - b.center));
  return answerOfSide(a.center, along(b.center, parameter, b.direction) - a.center, kNear);
}

struct LaneParameters {
  Number on_a, on_b;
};

/// Squared sine above which closestInLanes takes the first parameter from dot products. At lengths
/// of 10 m its error is then some 1e-12 m, and that of the distance a tenth of it.
constexpr double kSteep = 1e-2;

/// The first parameter as closestParameters finds it, at any angle.
HWY_INLINE Number firstOfFlat(const Vector3& between, const Vector3& u, Number half_a,
                              const Vector3& v, Number half_b) {
  const Vector3 n = cross(u, v);
  const Number sine_squared = dot(n, n);
  const Number b_on_a = dot(u, between);
  const Number crossing = hn::Div(dot(cross(between, v), n), sine_squared);
  const Number low = hn::Max(hn::Neg(half_a), hn::Sub(b_on_a, half_b));
  const Number high = hn::Min(half_a, hn::Add(b_on_a, half_b));
  const Number beside = hn::Mul(number(0.5), hn::Add(low, high));
  return hn::IfThenElse(hn::Gt(sine_squared, number(kParallel * kParallel)), crossing, beside);
}

/// closestParameters of closest_points.h, with fewer operations if directions are far from
/// parallel. No lane depends on the others. Lanes that do not count, as those of a body with itself
/// in a block, cost no extra work and hold any value.
HWY_INLINE LaneParameters closestInLanes(const Vector3& between, const Vector3& u, Number half_a,
                                         const Vector3& v, Number half_b, Truth counts) {
  const Number cosine = dot(u, v);
  const Number b_on_a = dot(u, between);
  const Number a_from_b = dot(v, between);  // minus the parameter of A's center on B
  const Number sine_squared = hn::Sub(number(1.0), hn::Mul(cosine, cosine));
  const Truth is_steep = hn::Gt(sine_squared, number(kSteep));
  Number first = hn::Div(hn::Sub(b_on_a, hn::Mul(cosine, a_from_b)), sine_squared);
  if (HWY_UNLIKELY(!isTrueWhere(counts, is_steep))) {
    first = hn::IfThenElse(is_steep, first, firstOfFlat(between, u, half_a, v, half_b));
  }
  const Number on_b = clamped(half_b, hn::Sub(hn::Mul(clamped(half_a, first), cosine), a_from_b));
  return {clamped(half_a, hn::Add(b_on_a, hn::Mul(on_b, cosine))), on_b};
}

/// Makes answers sure where segments nearly meet, each between its ends and at an angle: the normal
/// is perpendicular to both. This is normalOfNear's first case; the plain twin takes the others.
HWY_INLINE void sureOfCrossings(const SegmentCore& a, const SegmentCore& b,
                                const LaneParameters& closest, const Vector3& delta,
                                CoreAnswer& answer) {
  const Vector3 n = cross(a.direction, b.direction);
  const Number sine_squared = dot(n, n);
  const Number distance = norm(delta);
  const Truth is_crossing =
      hn::And(hn::And(hn::Le(distance, number(kNear)), hn::Gt(sine_squared, number(kSteep))),
              hn::And(hn::Lt(hn::Abs(closest.on_a), a.half_length),
                      hn::Lt(hn::Abs(closest.on_b), b.half_length)));
  const Number scale = hn::Div(signOf(dot(n, delta)), hn::Sqrt(sine_squared));
  answer.distance = hn::IfThenElse(is_crossing, distance, answer.distance);
  answer.normal = select(is_crossing, scaled(scale, n), answer.normal);
}

/// Correct in the lanes that count.
HWY_INLINE CoreAnswer coreDistance(const SegmentCore& a, const SegmentCore& b, Truth counts) {
  const Vector3 between = b.center - a.center;
  const LaneParameters closest =
      closestInLanes(between, a.direction, a.half_length, b.direction, b.half_length, counts);
  const Vector3 to_b = along(between, closest.on_b, b.direction);
  const Vector3 delta = to_b - scaled(closest.on_a, a.direction);
  const Number distance = norm(delta);
  const Vector3 on_a = along(a.center, closest.on_a, a.direction);
  CoreAnswer answer{distance, on_a, scaled(hn::Div(number(1.0), distance), delta)};
  const Truth is_sure = hn::Gt(distance, number(kNear));
  if (HWY_UNLIKELY(!isTrueWhere(counts, is_sure))) {
    answer.distance = sureWhere(is_sure, distance);
    sureOfCrossings(a, b, closest, delta, answer);
  }
  return answer;
}

HWY_INLINE CoreAnswer coreDistance(const SegmentCore& a, const SegmentCore& b) {
  return coreDistance(a, b, everywhere());
}

HWY_INLINE Number separationWithin(const SegmentCore& a, const SegmentCore& b, Number,
                                   Truth& counts) {
  return coreDistance(a, b, counts).distance;
}

/// Squared length of the positive gaps along three perpendicular axes, those of one of two boxes:
/// a bound of their squared distance.
HWY_INLINE Number outsideSquared(const Vector3& gaps) {
  const Vector3 outside{hn::Max(gaps.x, zero()), hn::Max(gaps.y, zero()), hn::Max(gaps.z, zero())};
  return dot(outside, outside);
}

/// Whether such gaps part the boxes by more than `reach`. False for NaN.
HWY_INLINE Truth isBeyond(const Vector3& gaps, Number reach) {
  const Number allowed = hn::Max(reach, zero());
  return hn::Gt(outsideSquared(gaps), hn::Mul(allowed, allowed));
}

/// The largest of three numbers, and where it is; the first of equal ones.
struct LargestOfThree {
  Number value;
  Truth is_y, is_z;
};

HWY_INLINE LargestOfThree largestOf(const Vector3& v) {
  const Truth is_y = hn::Gt(v.y, v.x);
  const Number of_two = hn::IfThenElse(is_y, v.y, v.x);
  const Truth is_z = hn::Gt(v.z, of_two);
  return {hn::IfThenElse(is_z, v.z, of_two), hn::AndNot(is_z, is_y), is_z};
}

/// `value` at the place of the largest, zero elsewhere.
HWY_INLINE Vector3 atPlaceOf(const LargestOfThree& largest, const Vector3& value) {
  return {hn::IfThenZeroElse(hn::Or(largest.is_y, largest.is_z), value.x),
          hn::IfThenElseZero(largest.is_y, value.y), hn::IfThenElseZero(largest.is_z, value.z)};
}

HWY_INLINE CoreAnswer coreDistance(const PointCore& a, const BoxCore& b) {
  const Vector3 here = into(b.axes, a.center - b.center);
  const Vector3 outward = here - clamped(b.half_extents, here);
  const Number outside = norm(outward);
  const Truth is_outside = hn::Gt(outside, number(kTouching));
  // Inside: the nearest face gives the depth.
  const LargestOfThree face = largestOf(absolute(here) - b.half_extents);
  const Vector3 inward =
      atPlaceOf(face, {hn::Neg(signOf(here.x)), hn::Neg(signOf(here.y)), hn::Neg(signOf(here.z))});
  const Vector3 normal =
      select(is_outside, scaled(hn::Div(number(-1.0), outside), outward), inward);
  const Number distance = hn::IfThenElse(is_outside, outside, face.value);
  // A NaN fails every comparison, which would read as inside.
  const Truth is_number = hn::Eq(outside, outside);
  return {sureWhere(is_number, distance), a.center, out(b.axes, normal)};
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#endif
