// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "collision_monitor/fitting/posed_shape.h"
#include "collision_monitor/geometry/geometry.h"

namespace collision_monitor::fit_tool {

/// A shape that every URDF reader knows, with its pose.
struct UrdfPiece {
  Geometry geometry;  ///< a Sphere, Box or Cylinder
  Pose link_from_geometry;
};

/// Pieces whose union is the shape. A capsule becomes a cylinder and two spheres. A rounded box
/// becomes its core, extended along each axis in turn, a cylinder for each edge and a sphere for
/// each corner.
/// Frames: the link's. Limits: parts of a core without extent are left out.
std::vector<UrdfPiece> piecesOf(const PosedShape& shape);

/// The shapes of one link in its frame.
struct LinkShapes {
  std::string link;  ///< its name in the URDF
  std::vector<PosedShape> shapes;
};

/// The URDF with the shapes in place of these links' collision and visual geometry. Everything else
/// stays, including other links.
///
/// Error: each shape is 1 nm larger, so that it encloses the original after its text is read back.
/// A reader that merges a cylinder and two spheres, such as ours, gets capsules.
/// @pre `urdf_xml` was read by readRobots without an error.
std::string writeUrdf(const std::string& urdf_xml, const std::vector<LinkShapes>& links);

}  // namespace collision_monitor::fit_tool
