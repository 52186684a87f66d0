// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "narrow_phase/closed_form/nearest_on_cylinder.h"
#include "narrow_phase/gjk/support_plane.h"

/// Follows a feature of another core beside a cylinder: finds its closest point on the cylinder,
/// and proves whether the cores are nearest there. A of every pair is the cylinder. Closest points
/// are in its frame, points of the other core in the other's.
namespace collision_monitor {

ClosestOnCylinder closestToCorner(const PlacedPair& pair, const Eigen::Vector3d& corner) noexcept;

/// An edge between two corners of the other core.
struct EdgeStart {
  const Eigen::Vector3d& first;
  const Eigen::Vector3d& second;
  const Eigen::Vector3d& last_closest;
};

/// @param share receives where on the edge, from 0 to 1, the search ended.
ClosestOnCylinder closestToEdge(const PlacedPair& pair, const EdgeStart& start,
                                double& share) noexcept;

/// @param on_other a point on the rim of the other core, also a cylinder: start of the search;
/// receives the result.
ClosestOnCylinder closestToRim(const PlacedPair& pair, Eigen::Vector3d& on_other) noexcept;

/// @param share the same on the axis of the other cylinder, from its lower to its upper end.
ClosestOnCylinder closestToAxis(const PlacedPair& pair, double& share) noexcept;

/// Finds the rim's point that is farthest towards a face with three corners.
/// @return false if it does not lie over the face.
bool closestToFace(const PlacedPair& pair, const std::array<Eigen::Vector3d, 3>& corners,
                   ClosestOnCylinder& closest) noexcept;

struct ClosestProof {
  double distance;         ///< [m]
  Eigen::Vector3d normal;  ///< unit, world frame, away from the cylinder
  bool is_apart;           ///< false: they touch or overlap, and the rest means nothing
  bool is_proven;          ///< nothing else is nearer or as near
};

/// Proves a closest point by the support planes across the direction out of the cylinder. The
/// pair's vertex of a hull becomes the one on the plane.
/// @param radius [m] of the other about the axis that was followed.
ClosestProof proveClosest(const PlacedPair& pair, const ClosestOnCylinder& closest,
                          double radius = 0.0) noexcept;

}  // namespace collision_monitor
