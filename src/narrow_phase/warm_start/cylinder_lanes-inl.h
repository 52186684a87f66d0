// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause

// nearest_on_cylinder.h, one pair per lane, in the same order to the last bit. Lanes that have
// ended keep their values while others continue.
#if defined(COLLISION_MONITOR_CYLINDER_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COLLISION_MONITOR_CYLINDER_LANES_INL_H_
#undef COLLISION_MONITOR_CYLINDER_LANES_INL_H_
#else
#define COLLISION_MONITOR_CYLINDER_LANES_INL_H_
#endif

#include "geometry/lanes/lanes-inl.h"
#include "narrow_phase/closed_form/nearest_on_cylinder.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

struct CylinderLanes {
  Number radius, half_length;
};

struct LaneProjection {
  Vector3 away;
  Number outward_x, outward_y;
  Number lag_around;
  Truth is_beside, is_beyond_cap;
};

HWY_INLINE LaneProjection project(const Vector3& point, const CylinderLanes& cylinder) {
  const Number off_axis = hn::Sqrt(hn::Add(hn::Mul(point.x, point.x), hn::Mul(point.y, point.y)));
  const Truth is_beside = hn::Gt(off_axis, cylinder.radius);
  const Number beyond = hn::IfThenElseZero(is_beside, hn::Sub(off_axis, cylinder.radius));
  const Number per_off_axis = hn::IfThenElseZero(is_beside, hn::Div(number(1.0), off_axis));
  const Number outward_x = hn::Mul(per_off_axis, point.x);
  const Number outward_y = hn::Mul(per_off_axis, point.y);
  const Number on_axis = clamped(cylinder.half_length, point.z);
  return {{hn::Mul(beyond, outward_x), hn::Mul(beyond, outward_y), hn::Sub(point.z, on_axis)},
          outward_x,
          outward_y,
          hn::Mul(beyond, per_off_axis),
          is_beside,
          hn::Gt(hn::Abs(point.z), cylinder.half_length)};
}

HWY_INLINE Number curvatureAlong(const Vector3& delta, const LaneProjection& at) {
  const Number outward = hn::Add(hn::Mul(at.outward_x, delta.x), hn::Mul(at.outward_y, delta.y));
  const Number around = hn::Sub(hn::Mul(delta.x, at.outward_y), hn::Mul(delta.y, at.outward_x));
  const Number of_side = hn::Add(hn::Mul(hn::Mul(at.lag_around, around), around),
                                 hn::IfThenElseZero(at.is_beside, hn::Mul(outward, outward)));
  return hn::Add(of_side, hn::IfThenElseZero(at.is_beyond_cap, hn::Mul(delta.z, delta.z)));
}

/// As ClosestOnCylinder.
struct LaneClosest {
  Vector3 on_cylinder, away;
};

HWY_INLINE LaneClosest closestOf(const Vector3& point, const CylinderLanes& cylinder) {
  const LaneProjection at = project(point, cylinder);
  return {point - at.away, at.away};
}

/// Clamps to [low, high], as std::max and std::min of scalars do.
HWY_INLINE Number within(double low, double high, Number value) {
  return hn::Max(number(low), hn::Min(number(high), value));
}

/// @param share start of the search; receives the result.
HWY_INLINE LaneClosest closestToEdge(const Vector3& from, const Vector3& edge,
                                     const CylinderLanes& cylinder, Number& share) {
  Vector3 point = along(from, share, edge);
  LaneProjection at = project(point, cylinder);
  Truth is_moving = hn::Eq(share, share);
  for (int step = 0; step < kMaxClosestSteps; ++step) {
    const Number curvature = curvatureAlong(edge, at);
    const Number next = within(0.0, 1.0, hn::Sub(share, hn::Div(dot(at.away, edge), curvature)));
    is_moving = hn::And(is_moving, hn::And(hn::Gt(curvature, zero()), hn::Ne(next, share)));
    if (hn::AllFalse(Lanes(), is_moving)) {
      break;
    }
    const Number delta = hn::Abs(hn::Sub(next, share));
    share = hn::IfThenElse(is_moving, next, share);
    point = along(from, share, edge);
    at = project(point, cylinder);
    is_moving = hn::And(is_moving, hn::Gt(delta, number(kLastClosestStep)));
  }
  return {point - at.away, at.away};
}

/// As Rim.
struct LaneRim {
  Vector3 center, x, y;
};

/// Cosine and sine.
struct LaneTurn {
  Number x, y;
};

/// s v + t w
HWY_INLINE Vector3 combined(Number s, const Vector3& v, Number t, const Vector3& w) {
  return along(scaled(s, v), t, w);
}

/// @param turn start of the search; receives the result.
HWY_INLINE LaneClosest closestToRim(const LaneRim& rim, const CylinderLanes& cylinder,
                                    LaneTurn& turn) {
  Vector3 outward = combined(turn.x, rim.x, turn.y, rim.y);
  Vector3 point = rim.center + outward;
  LaneProjection at = project(point, cylinder);
  Truth is_moving = hn::Eq(turn.x, turn.x);
  for (int step = 0; step < kMaxClosestSteps; ++step) {
    const Vector3 delta = combined(turn.x, rim.y, hn::Neg(turn.y), rim.x);
    const Number curvature = hn::Sub(curvatureAlong(delta, at), dot(at.away, outward));
    is_moving = hn::And(is_moving, hn::Gt(curvature, zero()));
    if (hn::AllFalse(Lanes(), is_moving)) {
      break;
    }
    const Number angle = within(-1.0, 1.0, hn::Div(hn::Neg(dot(at.away, delta)), curvature));
    const Number x = hn::Sub(turn.x, hn::Mul(angle, turn.y));
    const Number y = hn::Add(turn.y, hn::Mul(angle, turn.x));
    const Number per_length = hn::Div(number(1.0), hn::Sqrt(hn::Add(hn::Mul(x, x), hn::Mul(y, y))));
    turn.x = hn::IfThenElse(is_moving, hn::Mul(per_length, x), turn.x);
    turn.y = hn::IfThenElse(is_moving, hn::Mul(per_length, y), turn.y);
    outward = combined(turn.x, rim.x, turn.y, rim.y);
    point = rim.center + outward;
    at = project(point, cylinder);
    is_moving = hn::And(is_moving, hn::Gt(hn::Abs(angle), number(kLastClosestStep)));
  }
  return {point - at.away, at.away};
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#endif
