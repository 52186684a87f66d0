// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "collision_monitor/fitting/posed_shape.h"
#include "collision_monitor/geometry/geometry.h"

namespace collision_monitor::fit_tool {

/// A shape that any URDF reader knows, and its place.
struct UrdfPiece {
  Geometry geometry;  ///< a Sphere, Box or Cylinder
  Pose link_from_geometry;
};

/// Pieces whose union is the shape: a capsule is a cylinder and two spheres; a rounded box is its
/// core made longer along each axis, a cylinder for each edge and a sphere for each corner.
/// Frames: the link's. Limits: parts of a core without extent are left out.
std::vector<UrdfPiece> piecesOf(const PosedShape& shape);

/// The shapes of one link in its frame.
struct LinkShapes {
  std::string link;  ///< its name in the URDF
  std::vector<PosedShape> shapes;
};

/// The URDF with the shapes in place of what these links collide with and look like; all else
/// stays as it is, other links too.
///
/// Error: each shape is 1 nm larger, so that it holds the shape it stands for once its text is
/// read again. A reader that joins a cylinder and two spheres, as ours does, gets capsules.
/// @pre `urdf_xml` was read by readRobots without an error.
std::string writeUrdf(const std::string& urdf_xml, const std::vector<LinkShapes>& links);

}  // namespace collision_monitor::fit_tool
