// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "narrow_phase/closed_form/nearest_on_cylinder.h"
#include "narrow_phase/gjk/support_plane.h"

/// A cylinder and a feature of another core that is followed: where on the cylinder it is nearest,
/// and whether that is where the cores are. Of every pair A is the cylinder. Feet are in its frame,
/// points of the other in the other's. What is proven at first look is proven many at once, too, by
/// cylinder_rows.h, to the last bit the same.
namespace collision_monitor {

ClosestOnCylinder closestToCorner(const PlacedPair& pair, const Eigen::Vector3d& corner) noexcept;

/// Between two corners of the other.
struct EdgeStart {
  const Eigen::Vector3d& first;
  const Eigen::Vector3d& second;
  const Eigen::Vector3d& last_closest;
};

/// @param share where on the edge, from 0 to 1, it ended.
ClosestOnCylinder closestToEdge(const PlacedPair& pair, const EdgeStart& start,
                                double& share) noexcept;

/// @param on_other a point on the rim of the other, a cylinder, too: where to start, and where it
/// ended.
ClosestOnCylinder closestToRim(const PlacedPair& pair, Eigen::Vector3d& on_other) noexcept;

/// @param share the same of the axis of the other cylinder, from its lower end to its upper one.
ClosestOnCylinder closestToAxis(const PlacedPair& pair, double& share) noexcept;

/// The rim's point that is farthest towards a face with three corners.
/// @return false where it does not lie over it.
bool closestToFace(const PlacedPair& pair, const std::array<Eigen::Vector3d, 3>& corners,
                   ClosestOnCylinder& closest) noexcept;

struct ClosestProof {
  double distance;         ///< [m]
  Eigen::Vector3d normal;  ///< unit, world frame, away from the cylinder
  bool is_apart;           ///< false: they touch or overlap, the rest means nothing
  bool is_proven;          ///< nothing else is nearer, and nothing as near
};

/// By the support planes across the way out of the cylinder; of a hull the vertex on the plane is
/// then that of the pair.
/// @param radius [m] of the other about what was followed, its axis.
ClosestProof proveClosest(const PlacedPair& pair, const ClosestOnCylinder& closest,
                          double radius = 0.0) noexcept;

}  // namespace collision_monitor
