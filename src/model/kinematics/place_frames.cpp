// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/lanes/lane_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/kinematics/place_frames.cpp"
#include "hwy/foreach_target.h"
// The order matters: Highway includes this file first, once for each target.
#include "geometry/lanes/sine_lanes-inl.h"
#include "model/kinematics/state_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

HWY_INLINE void turnAboutZ(Number angle, PoseLanes& pose) {
  const SineCosine turn = sineCosine(angle);
  const Vector3 x = along(scaled(turn.cosine, pose.axes.x), turn.sine, pose.axes.y);
  pose.axes.y = scaled(turn.cosine, pose.axes.y) - scaled(turn.sine, pose.axes.x);
  pose.axes.x = x;
}

/// Rotation by the unit quaternion x, y, z, w; NaN if it is zero.
Axes axesOfQuaternion(Number x, Number y, Number z, Number w) {
  const Number one = number(1.0);
  const Number sum =
      hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Add(hn::Mul(z, z), hn::Mul(w, w)));
  const Number s = hn::Div(number(2.0), sum);
  const Number xs = hn::Mul(x, s), ys = hn::Mul(y, s), zs = hn::Mul(z, s);
  const Number xx = hn::Mul(x, xs), yy = hn::Mul(y, ys), zz = hn::Mul(z, zs);
  const Number xy = hn::Mul(x, ys), xz = hn::Mul(x, zs), yz = hn::Mul(y, zs);
  const Number wx = hn::Mul(w, xs), wy = hn::Mul(w, ys), wz = hn::Mul(w, zs);
  return {{hn::Sub(one, hn::Add(yy, zz)), hn::Add(xy, wz), hn::Sub(xz, wy)},
          {hn::Sub(xy, wz), hn::Sub(one, hn::Add(xx, zz)), hn::Add(yz, wx)},
          {hn::Add(xz, wy), hn::Sub(yz, wx), hn::Sub(one, hn::Add(xx, yy))}};
}

HWY_INLINE void moveFrame(const MovingFrame& frame, const StateNumber* variables, std::size_t lane,
                          PoseLanes& pose) {
  const auto variable = [&](std::size_t i) HWY_ATTR { return load(variables[i], lane); };
  const auto position = [&]() HWY_ATTR {
    return hn::Add(hn::Mul(number(frame.multiplier), variable(0)), number(frame.offset));
  };
  switch (frame.type) {
    case JointType::fixed:
      break;
    case JointType::revolute:
    case JointType::continuous:
      turnAboutZ(position(), pose);
      break;
    case JointType::prismatic:
      pose.translation = along(pose.translation, position(), pose.axes.z);
      break;
    case JointType::planar:
      pose.translation =
          along(along(pose.translation, variable(0), pose.axes.x), variable(1), pose.axes.y);
      turnAboutZ(variable(2), pose);
      break;
    case JointType::floating:
      pose = pose * PoseLanes{axesOfQuaternion(variable(3), variable(4), variable(5), variable(6)),
                              {variable(0), variable(1), variable(2)}};
      break;
  }
}

void placeInLanes(const KinematicsPlan& plan, const StateNumber* variables,
                  StatePose* world_from_frame) {
  for (std::size_t lane = 0; lane < kStateCount; lane += hn::Lanes(Lanes())) {
    for (std::size_t i = 0; i < plan.frames.size(); ++i) {
      const MovingFrame& frame = plan.frames[i];
      PoseLanes pose = everywhere(frame.parent_from_frame);
      if (frame.parent != MovingFrame::kWorld) {
        pose = load(world_from_frame[frame.parent], lane) * pose;
      }
      moveFrame(frame, variables + frame.first_variable, lane, pose);
      store(pose, lane, world_from_frame[i]);
    }
  }
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace collision_monitor {
namespace {
HWY_EXPORT(placeInLanes);
}  // namespace

void placeFrames(const KinematicsPlan& plan, const std::vector<StateNumber>& variables,
                 std::vector<StatePose>& world_from_frame) noexcept {
  HWY_DYNAMIC_DISPATCH(placeInLanes)(plan, variables.data(), world_from_frame.data());
}

}  // namespace collision_monitor
#endif
