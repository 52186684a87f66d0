// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace collision_monitor {

/// A rigid transform, named by the frames it joins. `world_from_link` takes coordinates in the link
/// frame to coordinates in the world frame, so equal frames meet in a chain:
/// `world_from_link * link_from_body`.
///
/// Units: metres. The rotation is a proper orthonormal matrix. Functions that read poses from
/// outside check it (isRigid); the others rely on it.
struct Pose {
  /// From the second frame named to the first.
  Eigen::Matrix3d rotation{Eigen::Matrix3d::Identity()};
  /// [m] Origin of the second frame, in the first.
  Eigen::Vector3d translation{Eigen::Vector3d::Zero()};
};

/// Chains two transforms.
inline Pose operator*(const Pose& a_from_b, const Pose& b_from_c) noexcept {
  Pose a_from_c;
  a_from_c.rotation.noalias() = a_from_b.rotation * b_from_c.rotation;
  a_from_c.translation.noalias() = a_from_b.rotation * b_from_c.translation;
  a_from_c.translation += a_from_b.translation;
  return a_from_c;
}

/// The coordinates of a point in the first frame named. [m].
inline Eigen::Vector3d operator*(const Pose& a_from_b, const Eigen::Vector3d& point_in_b) noexcept {
  return a_from_b.rotation * point_in_b + a_from_b.translation;
}

/// The transform the other way.
inline Pose inverse(const Pose& a_from_b) noexcept {
  Pose b_from_a;
  b_from_a.rotation = a_from_b.rotation.transpose();
  b_from_a.translation.noalias() = -(b_from_a.rotation * a_from_b.translation);
  return b_from_a;
}

/// True when no entry is NaN or infinite.
inline bool isFinite(const Pose& pose) noexcept {
  return pose.rotation.allFinite() && pose.translation.allFinite();
}

/// The limit for poses from outside, [m] from the origin of their frame, and for joint angles,
/// [rad]. There the last digit is 1e-7; beyond, measurements lose their meaning.
constexpr double kFarthest = 1e9;

/// The `tolerance` of isRigid for poses from outside.
constexpr double kRigid = 1e-6;

/// True when the pose is finite and its rotation is orthonormal and right-handed: the first two
/// columns are unit and orthogonal, and the third is their cross product. The sum of the squared
/// defects is at most the square of `tolerance`.
inline bool isRigid(const Pose& pose, double tolerance = kRigid) noexcept {
  // Runs for every link in every cycle, hence plain numbers and a single branch.
  const double* x = pose.rotation.data();
  const double* y = x + 3;
  const double* z = x + 6;
  const double defects[] = {x[0] * x[0] + x[1] * x[1] + x[2] * x[2] - 1.0,
                            y[0] * y[0] + y[1] * y[1] + y[2] * y[2] - 1.0,
                            x[0] * y[0] + x[1] * y[1] + x[2] * y[2],
                            x[1] * y[2] - x[2] * y[1] - z[0],
                            x[2] * y[0] - x[0] * y[2] - z[1],
                            x[0] * y[1] - x[1] * y[0] - z[2]};
  // This is 0, or NaN where the translation is not finite.
  double sum = (pose.translation - pose.translation).sum();
  for (const double defect : defects) {
    sum += defect * defect;
  }
  return sum <= tolerance * tolerance;
}

}  // namespace collision_monitor
