// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "motion/approach.h"

#include <Eigen/Geometry>
#include <cmath>

namespace collision_monitor {

double timeToConsume(double gap, const Consumption& consumption) noexcept {
  const double rate = consumption.rate;
  const double root = std::sqrt(rate * rate + 2.0 * consumption.growth * gap);
  // The positive root of growth / 2 t^2 + rate t = gap, in the form that does not cancel.
  return rate >= 0.0 ? 2.0 * gap / (rate + root) : (root - rate) / consumption.growth;
}

Approach approachAt(const ScrewMotion& motion_a, const ScrewMotion& motion_b, const Ball& ball_b,
                    double time) noexcept {
  const Pose a = poseAt(motion_a, time);
  const Pose b = poseAt(motion_b, time);
  // The velocities of both origins turn with their bodies.
  const Eigen::Vector3d travel_a =
      a.rotation * (motion_a.start.rotation.transpose() * motion_a.travel);
  const Eigen::Vector3d travel_b =
      b.rotation * (motion_b.start.rotation.transpose() * motion_b.travel);
  const Eigen::Vector3d arm = b.rotation * ball_b.center;
  const Eigen::Vector3d center_velocity = travel_b + motion_b.turn.cross(arm);
  Approach approach;
  approach.center = b.translation + arm;
  approach.turn = motion_b.turn - motion_a.turn;
  approach.velocity =
      center_velocity - travel_a - motion_a.turn.cross(approach.center - a.translation);
  approach.radius = ball_b.radius;
  approach.turn_length = approach.turn.norm();
  approach.point_speed = center_velocity.norm() + motion_b.turn.norm() * ball_b.radius;
  const double rest = 1.0 - time;
  const double relative_speed =
      approach.velocity.norm() +
      approach.turn_length * (ball_b.radius + rest * approach.point_speed);
  approach.plane_growth =
      motion_a.turn.norm() * relative_speed + approach.turn_length * approach.point_speed;
  return approach;
}

Consumption acrossPlane(const Approach& approach, const Eigen::Vector3d& normal) noexcept {
  return {approach.radius * normal.cross(approach.turn).norm() - normal.dot(approach.velocity),
          approach.plane_growth};
}

Consumption ofBall(const Approach& approach, const Eigen::Vector3d& center,
                   double radius) noexcept {
  return {approach.velocityAt(center).norm() + approach.turn_length * radius,
          approach.turn_length * approach.point_speed};
}

}  // namespace collision_monitor
