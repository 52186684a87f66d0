// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "collision_monitor/geometry/pose.h"
#include "collision_monitor/geometry/triangle_bvh.h"
#include "collision_monitor/model/robot_model.h"
#include "support_fcl/fcl_adapter.h"

/// A collision element for FCL, and what FCL does not know of it: its meshes have no inside.
namespace collision_monitor::test {

/// @return nullptr for a mesh without triangles.
FclGeometry fclGeometryOf(const Geometry& geometry);

struct Inside {
  std::optional<TriangleBvh> surface;  ///< that goes around it; of a mesh with triangles only
  /// Points of the geometry of which one is inside whatever it is inside of. Into a closed surface
  /// that it does not meet any would do; into an open one it may reach with some of them.
  std::vector<Eigen::Vector3d> marks;
};

Inside insideOf(const Geometry& geometry);

/// Undecided is what either answer is right for: a winding number above 1/2, to 0.52
/// (docs/accuracy.md, "Where exactness of meshes ends").
enum class Holds { no, undecided, yes };

/// Whether a mark of `inner` is inside the mesh `outer`.
Holds holdsMarkOf(const Inside& outer, const Pose& world_from_outer, const Inside& inner,
                  const Pose& world_from_inner);

}  // namespace collision_monitor::test
