// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause

// Poses of several states in SIMD lanes. `lane` is the first state of a vector.
#if defined(COLLISION_MONITOR_STATE_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COLLISION_MONITOR_STATE_LANES_INL_H_
#undef COLLISION_MONITOR_STATE_LANES_INL_H_
#else
#define COLLISION_MONITOR_STATE_LANES_INL_H_
#endif

#include "geometry/lanes/lanes-inl.h"
#include "model/kinematics/state_kinematics.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

struct PoseLanes {
  Axes axes;
  Vector3 translation;
};

HWY_INLINE Vector3 everywhere(const Eigen::Vector3d& v) {
  return {number(v[0]), number(v[1]), number(v[2])};
}

HWY_INLINE PoseLanes everywhere(const Pose& pose) {
  return {{everywhere(pose.rotation.col(0)), everywhere(pose.rotation.col(1)),
           everywhere(pose.rotation.col(2))},
          everywhere(pose.translation)};
}

HWY_INLINE Vector3 operator*(const PoseLanes& pose, const Vector3& point) {
  return pose.translation + out(pose.axes, point);
}

HWY_INLINE PoseLanes operator*(const PoseLanes& a_from_b, const PoseLanes& b_from_c) {
  return {{out(a_from_b.axes, b_from_c.axes.x), out(a_from_b.axes, b_from_c.axes.y),
           out(a_from_b.axes, b_from_c.axes.z)},
          a_from_b * b_from_c.translation};
}

HWY_INLINE Number load(const StateNumber& numbers, std::size_t lane) {
  return hn::Load(Lanes(), numbers.of + lane);
}

HWY_INLINE Vector3 load(const StateNumber (&v)[3], std::size_t lane) {
  return {load(v[0], lane), load(v[1], lane), load(v[2], lane)};
}

HWY_INLINE void store(const Vector3& v, std::size_t lane, StateNumber (&to)[3]) {
  hn::Store(v.x, Lanes(), to[0].of + lane);
  hn::Store(v.y, Lanes(), to[1].of + lane);
  hn::Store(v.z, Lanes(), to[2].of + lane);
}

HWY_INLINE PoseLanes load(const StatePose& pose, std::size_t lane) {
  return {{load(pose.axis_x, lane), load(pose.axis_y, lane), load(pose.axis_z, lane)},
          load(pose.translation, lane)};
}

HWY_INLINE void store(const PoseLanes& pose, std::size_t lane, StatePose& to) {
  store(pose.translation, lane, to.translation);
  store(pose.axes.x, lane, to.axis_x);
  store(pose.axes.y, lane, to.axis_y);
  store(pose.axes.z, lane, to.axis_z);
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#endif
