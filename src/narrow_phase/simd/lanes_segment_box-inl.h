// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause

// A segment and a box in lanes: distance_segment_box.cpp, with selections in place of branches.
#if defined(COLLISION_MONITOR_LANES_SEGMENT_BOX_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COLLISION_MONITOR_LANES_SEGMENT_BOX_INL_H_
#undef COLLISION_MONITOR_LANES_SEGMENT_BOX_INL_H_
#else
#define COLLISION_MONITOR_LANES_SEGMENT_BOX_INL_H_
#endif

#include "narrow_phase/simd/lanes_box_contact-inl.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

/// Frames: the box's.
struct SegmentInBox {
  Vector3 center, direction;
  Number half_length;
  Vector3 half_extents;
  Number rounding;
};

HWY_INLINE Number slopePart(Number center, Number direction, Number half, Number parameter,
                            Number rounding) {
  const Number x = hn::Add(center, hn::Mul(parameter, direction));
  const Number beyond = hn::Sub(x, clamped(half, x));
  return hn::IfThenElseZero(hn::Gt(hn::Abs(beyond), rounding), hn::Mul(beyond, direction));
}

/// Half the derivative of the squared distance along the segment.
HWY_INLINE Number slopeInLanes(const SegmentInBox& pair, Number parameter) {
  const Vector3& c = pair.center;
  const Vector3& d = pair.direction;
  const Vector3& half = pair.half_extents;
  return hn::Add(hn::Add(slopePart(c.x, d.x, half.x, parameter, pair.rounding),
                         slopePart(c.y, d.y, half.y, parameter, pair.rounding)),
                 slopePart(c.z, d.z, half.z, parameter, pair.rounding));
}

/// Where the slope changes sign, as Bracket of the plain twin.
struct BracketLanes {
  Number low, slope_low, high, slope_high, flat_low, flat_high;
};

HWY_INLINE void narrow(Truth counts, Number parameter, Number slope, BracketLanes& bracket) {
  const Truth is_below = hn::And(counts, hn::Lt(slope, zero()));
  const Truth is_above = hn::And(counts, hn::Gt(slope, zero()));
  const Truth is_flat = hn::And(counts, hn::Eq(slope, zero()));
  bracket.low = hn::IfThenElse(is_below, parameter, bracket.low);
  bracket.slope_low = hn::IfThenElse(is_below, slope, bracket.slope_low);
  bracket.high = hn::IfThenElse(is_above, parameter, bracket.high);
  bracket.slope_high = hn::IfThenElse(is_above, slope, bracket.slope_high);
  const Number low = hn::Min(bracket.flat_low, parameter);
  const Number high = hn::Max(bracket.flat_high, parameter);
  bracket.flat_low = hn::IfThenElse(is_flat, low, bracket.flat_low);
  bracket.flat_high = hn::IfThenElse(is_flat, high, bracket.flat_high);
}

/// Narrows the bracket where the segment crosses the two planes of a slab.
HWY_INLINE void narrowAtSlab(const SegmentInBox& pair, Number center, Number direction, Number half,
                             BracketLanes& bracket) {
  for (const Number face : {hn::Neg(half), half}) {
    const Number parameter = hn::Div(hn::Sub(face, center), direction);
    const Truth is_inside =
        hn::And(hn::Gt(parameter, bracket.low), hn::Lt(parameter, bracket.high));
    narrow(is_inside, parameter, slopeInLanes(pair, parameter), bracket);
  }
}

HWY_INLINE Number nearestInLanes(const SegmentInBox& pair) {
  const Number end = pair.half_length;
  const Number start = hn::Neg(end);
  const Number slope_first = slopeInLanes(pair, start);
  const Number slope_last = slopeInLanes(pair, end);
  BracketLanes bracket{start, slope_first, end, slope_last, end, start};
  const Truth all = hn::Eq(zero(), zero());
  narrow(all, start, slope_first, bracket);
  narrow(all, end, slope_last, bracket);
  narrowAtSlab(pair, pair.center.x, pair.direction.x, pair.half_extents.x, bracket);
  narrowAtSlab(pair, pair.center.y, pair.direction.y, pair.half_extents.y, bracket);
  narrowAtSlab(pair, pair.center.z, pair.direction.z, pair.half_extents.z, bracket);
  const Number share = hn::Div(bracket.slope_low, hn::Sub(bracket.slope_low, bracket.slope_high));
  const Number between = hn::Add(bracket.low, hn::Mul(share, hn::Sub(bracket.high, bracket.low)));
  const Number flat = hn::Mul(number(0.5), hn::Add(bracket.flat_low, bracket.flat_high));
  const Number within = hn::IfThenElse(hn::Le(bracket.flat_low, bracket.flat_high), flat, between);
  return hn::IfThenElse(hn::Gt(slope_first, zero()), start,
                        hn::IfThenElse(hn::Lt(slope_last, zero()), end, within));
}

/// Directions that are parallel to a face up to rounding become exactly so.
HWY_INLINE Number cleaned(Number component) {
  return hn::IfThenElseZero(hn::Gt(hn::Abs(component), number(kParallel)), component);
}

HWY_INLINE CoreAnswer coreDistance(const SegmentCore& a, const BoxCore& b) {
  const Vector3 direction = into(b.axes, a.direction);
  const Vector3 half_segment{zero(), zero(), a.half_length};
  const Vector3 center = into(b.axes, a.center - b.center);
  const Number tolerance = toleranceInLanes(b.half_extents, half_segment, center);
  const SegmentInBox here{center,
                          {cleaned(direction.x), cleaned(direction.y), cleaned(direction.z)},
                          a.half_length,
                          b.half_extents,
                          tolerance};
  Vector3 on_segment = along(center, nearestInLanes(here), here.direction);
  const Vector3 between = clamped(b.half_extents, on_segment) - on_segment;
  Number distance = norm(between);
  Vector3 normal = scaled(hn::Div(number(1.0), distance), between);
  const Truth is_apart = hn::Gt(distance, number(kNear));
  const Truth is_through = hn::Le(distance, number(kTouching));
  Truth is_sure = is_apart;
  if (!hn::AllFalse(Lanes(), is_through)) {
    const Vector3 none{zero(), zero(), zero()};
    const BoxPairLanes pair{
        {none, none, direction}, center, b.half_extents, half_segment, tolerance};
    const AxisContact contact = contactAlong(pair, bestAxis<true>(pair));
    is_sure = hn::Or(is_apart, hn::And(is_through, hn::And(contact.holds, isSkew(direction))));
    distance = hn::IfThenElse(is_through, contact.gap, distance);
    normal = select(is_through, negated(contact.normal), normal);
    on_segment =
        select(is_through, along(contact.point_on_a, contact.gap, contact.normal), on_segment);
  }
  return {sureWhere(is_sure, distance), b.center + out(b.axes, on_segment), out(b.axes, normal)};
}

/// The extents of the segment along the axes of the box part most pairs.
HWY_INLINE Number separationWithin(const SegmentCore& a, const BoxCore& b, Number reach,
                                   Truth& counts) {
  const Vector3 center = into(b.axes, a.center - b.center);
  const Vector3 beside = absolute(into(b.axes, a.direction));
  const Vector3 gaps = absolute(center) - along(b.half_extents, a.half_length, beside);
  const Vector3 half_segment{zero(), zero(), a.half_length};
  const Number tolerance = toleranceInLanes(b.half_extents, half_segment, center);
  counts = hn::AndNot(isBeyond(gaps, hn::Add(reach, tolerance)), counts);
  return hn::AllFalse(Lanes(), counts) ? zero() : coreDistance(a, b).distance;
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#endif
