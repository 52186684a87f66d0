// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <coal/BVH/BVH_model.h>
#include <coal/collision_data.h>
#include <coal/collision_object.h>

#include <memory>

#include "collision_monitor/geometry/geometry.h"
#include "collision_monitor/geometry/pose.h"
#include "collision_monitor/narrow_phase/convex_distance.h"

/// Coal as a peer of the benchmarks, with the requests that it answers fastest. Coal grew out of
/// FCL, so most names are the same.
namespace collision_monitor::test {

using CoalObject = coal::CollisionObject;
using CoalGeometry = std::shared_ptr<coal::CollisionGeometry>;
using CoalMesh = coal::BVHModel<coal::OBBRSS>;

/// @return nullptr for a rounded box with a radius and for a half space, as toFclGeometry.
CoalGeometry toCoalGeometry(const ConvexGeometry& geometry);

/// @return nullptr for a mesh without triangles.
CoalGeometry coalGeometryOf(const Geometry& geometry);

/// A mesh with the bounds that FCL has in these benchmarks, too.
std::shared_ptr<CoalMesh> toCoal(const TriangleMesh& mesh);

CoalObject coalObject(const CoalGeometry& geometry, const Pose& world_from_geometry);

/// Stops at the first contact. Looks for no contact points, and measures no distance.
bool coalOverlap(const CoalObject& a, const CoalObject& b);

/// A request that starts each search without a guess.
/// @param with_depth of convex geometries that overlap; else their distance is 0 or less
coal::DistanceRequest coalRequest(bool with_depth);

/// A request for one pair in motion: each search starts where the last one ended. Meshes have none.
coal::DistanceRequest warmCoalRequest(bool with_depth);

/// Lowers `result.min_distance` to the distance of a pair, and searches for nothing farther apart.
void lowerByCoal(const CoalObject& a, const CoalObject& b, const coal::DistanceRequest& request,
                 coal::DistanceResult& result);

/// The distance of a pair alone. It is 0 or less where surfaces cross.
double coalDistance(const CoalObject& a, const CoalObject& b, const coal::DistanceRequest& request);

}  // namespace collision_monitor::test
