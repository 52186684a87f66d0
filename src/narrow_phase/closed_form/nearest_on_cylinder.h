// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

/// Every number is summed in the order of lanes, so that cylinder_lanes-inl.h finds the same to the
/// last bit.
namespace collision_monitor {

constexpr int kMaxClosestSteps = 12;
/// Of Newton's method: the step after one as small as this would be its square.
constexpr double kLastClosestStep = 1e-8;

/// A point outside of a solid cylinder and its nearest point there, in the cylinder's frame.
struct ClosestOnCylinder {
  Eigen::Vector3d on_cylinder{Eigen::Vector3d::Zero()};
  Eigen::Vector3d away{Eigen::Vector3d::Zero()};  ///< from there to the point; zero within
};

/// @param half_extents radius, radius, half length.
ClosestOnCylinder closestOf(const Eigen::Vector3d& point,
                            const Eigen::Vector3d& half_extents) noexcept;

/// The foot of the point of a segment, `from` + `share` * `edge` with 0 <= share <= 1, that is
/// nearest to the cylinder.
///
/// Error: quadratic convergence; who needs a proof looks at a support plane.
/// @param share where to start, and where it ended.
ClosestOnCylinder closestToEdge(const Eigen::Vector3d& from, const Eigen::Vector3d& edge,
                                const Eigen::Vector3d& half_extents, double& share) noexcept;

/// A circle: center + cos * across.col(0) + sin * across.col(1).
struct Rim {
  Eigen::Vector3d center;
  Eigen::Matrix<double, 3, 2> across;
};

/// The same of the point of a rim, near the start, that is nearest to the cylinder.
/// @param turn unit, its cosine and sine: where to start, and where it ended.
ClosestOnCylinder closestToRim(const Rim& rim, const Eigen::Vector3d& half_extents,
                               Eigen::Vector2d& turn) noexcept;

}  // namespace collision_monitor
