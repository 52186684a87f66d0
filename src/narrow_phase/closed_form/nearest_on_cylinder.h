// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

/// Closest points of a solid cylinder.
namespace collision_monitor {

constexpr int kMaxClosestSteps = 12;
/// Newton's method stops after a step this small: the next one would be its square.
constexpr double kLastClosestStep = 1e-8;

/// The closest point of a solid cylinder to a point outside. Frames: the cylinder's.
struct ClosestOnCylinder {
  Eigen::Vector3d on_cylinder{Eigen::Vector3d::Zero()};
  Eigen::Vector3d away{Eigen::Vector3d::Zero()};  ///< from on_cylinder to the point; zero inside
};

/// @param half_extents radius, radius, half length.
ClosestOnCylinder closestOf(const Eigen::Vector3d& point,
                            const Eigen::Vector3d& half_extents) noexcept;

/// Finds the point of a segment that is nearest to the cylinder, and its closest point there. The
/// segment is `from` + `share` * `edge` with 0 <= share <= 1.
///
/// Error: converges quadratically. A caller that needs a proof checks a support plane.
/// @param share start of the search; receives the result.
ClosestOnCylinder closestToEdge(const Eigen::Vector3d& from, const Eigen::Vector3d& edge,
                                const Eigen::Vector3d& half_extents, double& share) noexcept;

/// A circle: center + cos * across.col(0) + sin * across.col(1).
struct Rim {
  Eigen::Vector3d center;
  Eigen::Matrix<double, 3, 2> across;
};

/// The same for the point of a rim that is nearest to the cylinder, close to the start.
/// @param turn unit, cosine and sine: start of the search; receives the result.
ClosestOnCylinder closestToRim(const Rim& rim, const Eigen::Vector3d& half_extents,
                               Eigen::Vector2d& turn) noexcept;

}  // namespace collision_monitor
