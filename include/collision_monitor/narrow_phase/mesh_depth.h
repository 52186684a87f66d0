// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/narrow_phase/mesh_distance.h"

namespace collision_monitor {

/// How deep two meshes are in each other, between two proven bounds.
///
/// The depth is the length of the least translation that separates the solids. For meshes that are
/// not convex nobody computes it in a cycle; what is offered are the point of either surface that
/// is deepest inside the other solid, which every separating translation has to bring out, and the
/// best of several directions in which one mesh can be pulled off the other entirely.
struct MeshPenetration {
  /// [m] No shorter translation separates the solids. 0 when no corner of either is found inside
  /// the other, or a mesh has no inside.
  double at_least{0.0};
  /// [m] Moving B by this along `way_out` separates them; may be far more than needed where one
  /// hooks into the other. At most 0 when they are separated.
  double at_most{std::numeric_limits<double>::infinity()};
  Eigen::Vector3d way_out{Eigen::Vector3d::UnitX()};
  /// The deepest corner found and the point of the other surface nearest to it: distance is
  /// -at_least. An estimate of the contact as SignedDistance would give it; its normal is the
  /// local way out.
  SignedDistance deepest;
  bool is_complete{false};  ///< false: the budget ended the search, or a pose is not finite
};

/// Frames: world. Units: metres.
/// Error: `at_least` exact to 1e-12 m for the corners looked at; when complete it is the largest
/// over all corners of both meshes. `at_most` to 1e-12 m.
/// Limits: two solids may cross with no corner of one in the other (crossed bars): `at_least` is
/// then 0 and says nothing. Each point costs about as much as the distance of a mesh and a sphere;
/// the budget counts the points of each mesh whose depth is measured.
/// Source: signed distance changes by no more than the way gone, so a node whose centre is not deep
/// enough for its size is passed over: Guthe, Borodin, Klein, "Fast and accurate Hausdorff distance
/// calculation between meshes" (2005), for such bounds.
/// @pre as distanceBetween. @param memory its content means nothing afterwards.
MeshPenetration penetrationOf(const PlacedMesh& a, const PlacedMesh& b, MeshQueryMemory& memory,
                              std::uint32_t point_budget = 100) noexcept;

}  // namespace collision_monitor
