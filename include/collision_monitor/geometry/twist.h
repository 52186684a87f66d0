// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace collision_monitor {

/// The velocity of a rigid body at one moment. The body's point at `p` moves with
/// `linear + angular x p`, so two bodies that move as one have the same twist.
///
/// Frames: world. Units: [m/s] and [rad/s].
/// Source: Featherstone, "Rigid Body Dynamics Algorithms" (2008), section 2.2.
struct Twist {
  Eigen::Vector3d linear{Eigen::Vector3d::Zero()};   ///< of the body's point at the world's origin
  Eigen::Vector3d angular{Eigen::Vector3d::Zero()};  ///< [rad/s]
};

/// The twist of a body that moves with `b` relative to a frame that moves with `a`.
inline Twist operator+(const Twist& a, const Twist& b) noexcept {
  return {a.linear + b.linear, a.angular + b.angular};
}

/// The twist of a body with `a` as seen from one with `b`, in the axes of the world.
inline Twist operator-(const Twist& a, const Twist& b) noexcept {
  return {a.linear - b.linear, a.angular - b.angular};
}

/// The same motion, `factor` times as fast.
inline Twist operator*(double factor, const Twist& twist) noexcept {
  return {factor * twist.linear, factor * twist.angular};
}

/// Velocity of the body's point at `point`.
inline Eigen::Vector3d velocityAt(const Twist& twist, const Eigen::Vector3d& point) noexcept {
  // Written by component: Eigen would store the product and stall when it loads it as vectors.
  const Eigen::Vector3d& v = twist.linear;
  const Eigen::Vector3d& w = twist.angular;
  return {v.x() + (w.y() * point.z() - w.z() * point.y()),
          v.y() + (w.z() * point.x() - w.x() * point.z()),
          v.z() + (w.x() * point.y() - w.y() * point.x())};
}

/// The twist of a body that turns with `angular` while its point at `point` moves with `velocity`.
inline Twist twistAbout(const Eigen::Vector3d& point, const Eigen::Vector3d& velocity,
                        const Eigen::Vector3d& angular) noexcept {
  return {velocity - angular.cross(point), angular};
}

/// The sum of forces on a rigid body. Frames: world. Units: [N] and [Nm].
/// Source: Featherstone (2008), section 2.3.
struct Wrench {
  Eigen::Vector3d force{Eigen::Vector3d::Zero()};   ///< [N]
  Eigen::Vector3d torque{Eigen::Vector3d::Zero()};  ///< about the world's origin
};

/// The wrench of one force that acts at a point.
inline Wrench forceAt(const Eigen::Vector3d& point, const Eigen::Vector3d& force) noexcept {
  return {force, point.cross(force)};
}

/// The wrench that balances it.
inline Wrench operator-(const Wrench& wrench) noexcept { return {-wrench.force, -wrench.torque}; }

/// The power [W] of a wrench on a body that moves with `twist`. For `forceAt` it is the force times
/// the velocity of its point.
inline double power(const Wrench& wrench, const Twist& twist) noexcept {
  const auto dot = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();  // see velocityAt
  };
  return dot(wrench.force, twist.linear) + dot(wrench.torque, twist.angular);
}

/// True when no entry is NaN or infinite.
inline bool isFinite(const Twist& twist) noexcept {
  return twist.linear.allFinite() && twist.angular.allFinite();
}

}  // namespace collision_monitor
