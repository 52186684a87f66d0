// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "collision_monitor/geometry/pose.h"
#include "collision_monitor/narrow_phase/signed_distance.h"

/// What every pair of cores shares. A core routine answers for the bare cores (radius 0) in one
/// working frame; these functions add the radii and carry the answer to the world.
namespace collision_monitor {

/// Cores nearer than this [m] count as touching: their difference is then mostly rounding, so
/// the normal is taken from the features that touch instead.
constexpr double kTouching = 1e-13;

/// Below this distance [m] the direction of a difference, which is known to about 1e-15 m over the
/// distance, is worse than what is known of the features, and they are used to clean it.
constexpr double kNear = 1e-2;

/// Directions whose sine is below this are parallel: over 10 m they part by 1e-13 m.
constexpr double kParallel = 1e-14;

inline double signOf(double value) noexcept { return value < 0.0 ? -1.0 : 1.0; }

/// The same answer with A and B exchanged.
inline SignedDistance swapped(const SignedDistance& ab) noexcept {
  return {ab.distance, ab.point_on_b, ab.point_on_a, -ab.normal_a_to_b};
}

/// The same answer in another frame.
inline SignedDistance placed(const Pose& world_from_frame,
                             const SignedDistance& in_frame) noexcept {
  return {in_frame.distance, world_from_frame * in_frame.point_on_a,
          world_from_frame * in_frame.point_on_b,
          world_from_frame.rotation * in_frame.normal_a_to_b};
}

/// Shapes from their cores: the surface lies one radius outside the core along the normal.
/// Holds for overlapping cores too, because the facet that is least deep moves out with the rest.
inline SignedDistance inflated(const SignedDistance& cores, double radius_a,
                               double radius_b) noexcept {
  return {cores.distance - radius_a - radius_b, cores.point_on_a + radius_a * cores.normal_a_to_b,
          cores.point_on_b - radius_b * cores.normal_a_to_b, cores.normal_a_to_b};
}

/// A unit vector perpendicular to a unit vector; the same one every time.
Eigen::Vector3d perpendicularTo(const Eigen::Vector3d& direction) noexcept;

}  // namespace collision_monitor
