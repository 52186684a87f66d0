// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "collision_monitor/geometry/pose.h"
#include "collision_monitor/narrow_phase/signed_distance.h"

/// What all pairs of cores share. A core routine measures bare cores (radius 0) in one working
/// frame. These functions add the radii and take the answer to the world frame.
namespace collision_monitor {

/// [m] Cores nearer than this count as touching. Their difference is mostly rounding, so the normal
/// comes from the touching features.
constexpr double kTouching = 1e-13;

/// [m] Below this distance the features correct the direction of a difference. Its error, about
/// 1e-15 m over the distance, exceeds that of the features.
constexpr double kNear = 1e-2;

/// Directions with a sine below this are parallel: over 10 m they part by 1e-13 m.
constexpr double kParallel = 1e-14;

inline double signOf(double value) noexcept { return value < 0.0 ? -1.0 : 1.0; }

/// Exchanges A and B.
inline SignedDistance swapped(const SignedDistance& ab) noexcept {
  return {ab.distance, ab.point_on_b, ab.point_on_a, -ab.normal_a_to_b};
}

/// Takes an answer to another frame.
inline SignedDistance placed(const Pose& world_from_frame,
                             const SignedDistance& in_frame) noexcept {
  return {in_frame.distance, world_from_frame * in_frame.point_on_a,
          world_from_frame * in_frame.point_on_b,
          world_from_frame.rotation * in_frame.normal_a_to_b};
}

/// Adds the radii: each surface lies one radius outside its core along the normal. Also holds for
/// overlapping cores, because the facet of least depth moves out with the rest.
inline SignedDistance inflated(const SignedDistance& cores, double radius_a,
                               double radius_b) noexcept {
  return {cores.distance - radius_a - radius_b, cores.point_on_a + radius_a * cores.normal_a_to_b,
          cores.point_on_b - radius_b * cores.normal_a_to_b, cores.normal_a_to_b};
}

/// A unit vector perpendicular to a unit vector; always the same one.
Eigen::Vector3d perpendicularTo(const Eigen::Vector3d& direction) noexcept;

}  // namespace collision_monitor
