// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "motion/screw_motion.h"

#include <Eigen/Geometry>
#include <cmath>

namespace collision_monitor {
namespace {

/// [rad] Smaller angles use series, whose next terms are beyond double precision.
constexpr double kSmallAngle = 1e-4;

/// [rad or its sine] As kSmallAngle, for inverse functions.
constexpr double kModestAngle = 0.02;

/// [rad] The greatest difference by rounding between poses of equal rotation.
constexpr double kNoTurn = 1e-15;

/// asin(x) / x for small x.
double arcSineShare(double x_squared) noexcept {
  return 1.0 + x_squared * (1.0 / 6.0 +
                            x_squared * (3.0 / 40.0 +
                                         x_squared * (5.0 / 112.0 + x_squared * (35.0 / 1152.0))));
}

Eigen::Vector3d turnBetween(const Eigen::Matrix3d& start, const Eigen::Matrix3d& end) noexcept {
  const Eigen::Matrix3d between = end * start.transpose();
  // Points along the axis; its length is the sine of the angle.
  const Eigen::Vector3d across(0.5 * (between(2, 1) - between(1, 2)),
                               0.5 * (between(0, 2) - between(2, 0)),
                               0.5 * (between(1, 0) - between(0, 1)));
  const double square = across.squaredNorm();
  if (square < kModestAngle * kModestAngle && between.trace() > 1.0) {
    return square > kNoTurn * kNoTurn ? Eigen::Vector3d(arcSineShare(square) * across)
                                      : Eigen::Vector3d(Eigen::Vector3d::Zero());
  }
  Eigen::Quaterniond turn(between);
  if (turn.w() < 0.0) {
    turn.coeffs() = -turn.coeffs();
  }
  const double sine = turn.vec().norm();
  if (!(sine > 0.5 * kNoTurn)) {
    return Eigen::Vector3d::Zero();
  }
  return 2.0 * std::atan2(sine, turn.w()) / sine * turn.vec();
}

Eigen::Matrix3d rotationBy(const Eigen::Vector3d& turn) noexcept {
  const double angle = turn.norm();
  const Eigen::Vector3d axis = angle > 0.0 ? Eigen::Vector3d(turn / angle) : turn;
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

/// The integral of a velocity that turns along: the displacement of a point.
Eigen::Vector3d shiftOf(const Eigen::Vector3d& turn, const Eigen::Vector3d& velocity) noexcept {
  const double angle = turn.norm();
  const double square = angle * angle;
  const bool is_small = angle < kSmallAngle;
  const double half_sine = std::sin(0.5 * angle);
  const double first = is_small ? 0.5 - square / 24.0 : 2.0 * half_sine * half_sine / square;
  const double second =
      is_small ? 1.0 / 6.0 - square / 120.0 : (angle - std::sin(angle)) / (square * angle);
  const Eigen::Vector3d across = turn.cross(velocity);
  return velocity + first * across + second * turn.cross(across);
}

/// The inverse of shiftOf.
Eigen::Vector3d velocityOf(const Eigen::Vector3d& turn, const Eigen::Vector3d& shift) noexcept {
  const double angle = turn.norm();
  const double square = angle * angle;
  const double factor = angle < kModestAngle
                            ? 1.0 / 12.0 + square * (1.0 / 720.0 + square / 30240.0)
                            : (1.0 - 0.5 * angle / std::tan(0.5 * angle)) / square;
  const Eigen::Vector3d across = turn.cross(shift);
  return shift - 0.5 * across + factor * turn.cross(across);
}

}  // namespace

ScrewMotion screwBetween(const Pose& start, const Pose& end) noexcept {
  ScrewMotion motion;
  motion.start = start;
  motion.turn = turnBetween(start.rotation, end.rotation);
  motion.travel = velocityOf(motion.turn, end.translation - start.translation);
  return motion;
}

Pose poseAt(const ScrewMotion& motion, double time) noexcept {
  if (motion.turn == Eigen::Vector3d::Zero() && motion.travel == Eigen::Vector3d::Zero()) {
    return motion.start;  // what follows takes long, and much is at rest
  }
  const Eigen::Vector3d turn = time * motion.turn;
  return {rotationBy(turn) * motion.start.rotation,
          motion.start.translation + shiftOf(turn, time * motion.travel)};
}

Eigen::Vector3d velocityAt(const ScrewMotion& motion, const Eigen::Vector3d& point) noexcept {
  return motion.travel + motion.turn.cross(motion.start.rotation * point);
}

double arcHeight(const ScrewMotion& motion, const Eigen::Vector3d& point) noexcept {
  return 0.125 * motion.turn.cross(velocityAt(motion, point)).norm();
}

ScrewMotion carriedBy(const ScrewMotion& link_motion, const Pose& link_from_body) noexcept {
  return {link_motion.start * link_from_body, link_motion.turn,
          velocityAt(link_motion, link_from_body.translation)};
}

Aabb sweptAabbOf(const Shape& shape, const ScrewMotion& motion, const Pose& end,
                 double margin) noexcept {
  // Every point is within its arc's height of a chord, and the chords lie in the hull of both ends.
  const double arc = arcHeight(motion, Eigen::Vector3d::Zero()) +
                     0.125 * motion.turn.squaredNorm() * boundingRadius(shape);
  const Aabb first = aabbOf(shape, motion.start, margin + arc);
  const Aabb last = aabbOf(shape, end, margin + arc);
  return {first.min.cwiseMin(last.min), first.max.cwiseMax(last.max)};
}

}  // namespace collision_monitor
