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

/// A segment seen from a box, and its point nearest to the box. Frames: the box's.
struct SegmentByBox {
  Vector3 center;
  Vector3 direction;
  Number half_length;
  Vector3 half_box;
  Number tolerance;
  Vector3 on_segment{};
  Vector3 to_box{};   ///< from there
  Number distance{};  ///< 0 where the segment is in the box

  HWY_INLINE Truth isThrough() const { return hn::Le(distance, number(kTouching)); }

  HWY_INLINE BoxPairLanes asPair() const {
    const Vector3 none{zero(), zero(), zero()};
    return {{none, none, direction}, center, half_box, {zero(), zero(), half_length}, tolerance};
  }
};

HWY_INLINE SegmentByBox seenFromBox(const SegmentCore& a, const BoxCore& b) {
  const Vector3 center = into(b.axes, a.center - b.center);
  const Vector3 half_segment{zero(), zero(), a.half_length};
  return {center, into(b.axes, a.direction), a.half_length, b.half_extents,
          toleranceInLanes(b.half_extents, half_segment, center)};
}

HWY_INLINE void findNearest(SegmentByBox& pair) {
  const SegmentInBox here{
      pair.center,
      {cleaned(pair.direction.x), cleaned(pair.direction.y), cleaned(pair.direction.z)},
      pair.half_length,
      pair.half_box,
      pair.tolerance};
  pair.on_segment = along(pair.center, nearestInLanes(here), here.direction);
  pair.to_box = clamped(pair.half_box, pair.on_segment) - pair.on_segment;
  pair.distance = norm(pair.to_box);
}

HWY_INLINE CoreAnswer coreDistance(const SegmentCore& a, const BoxCore& b) {
  SegmentByBox pair = seenFromBox(a, b);
  findNearest(pair);
  Number distance = pair.distance;
  Vector3 on_segment = pair.on_segment;
  Vector3 normal = scaled(hn::Div(number(1.0), distance), pair.to_box);
  const Truth is_apart = hn::Gt(distance, number(kNear));
  const Truth is_through = pair.isThrough();
  Truth is_sure = is_apart;
  if (!hn::AllFalse(Lanes(), is_through)) {
    const BoxPairLanes boxes = pair.asPair();
    const AxisContact contact = contactAlong(boxes, bestAxis<true>(boxes));
    is_sure = hn::Or(is_apart, hn::And(is_through, hn::And(contact.holds, isSkew(pair.direction))));
    distance = hn::IfThenElse(is_through, contact.gap, distance);
    normal = select(is_through, negated(contact.normal), normal);
    on_segment =
        select(is_through, along(contact.point_on_a, contact.gap, contact.normal), on_segment);
  }
  return {sureWhere(is_sure, distance), b.center + out(b.axes, on_segment), out(b.axes, normal)};
}

/// The extents of the segment along the axes of the box part most pairs. Where the segment is in
/// the box, the best axis gives the depth, and no point needs to prove it.
HWY_INLINE Number separationWithin(const SegmentCore& a, const BoxCore& b, Number reach,
                                   Truth& counts) {
  SegmentByBox pair = seenFromBox(a, b);
  const Vector3 gaps =
      absolute(pair.center) - along(b.half_extents, a.half_length, absolute(pair.direction));
  counts = hn::AndNot(isBeyond(gaps, hn::Add(reach, pair.tolerance)), counts);
  if (hn::AllFalse(Lanes(), counts)) {
    return zero();
  }
  findNearest(pair);
  const Truth is_through = pair.isThrough();
  return hn::AllFalse(Lanes(), is_through)
             ? pair.distance
             : hn::IfThenElse(is_through, gapAlong(bestAxis<true>(pair.asPair())), pair.distance);
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#endif
