// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fit_robot.h"

namespace collision_monitor::fit_tool {

/// Units: cubic metres. For a mesh, the volume of its convex hull, 0 if it is flat.
double hullVolumeOf(const Geometry& geometry);

/// The volume of the union of the shapes.
/// Error: exact for one shape; else about 1 %, from 64 samples along each axis.
/// Units: cubic metres.
double unionVolumeOf(const std::vector<PosedShape>& shapes);

/// The overshoot of the union of shapes over a mesh. Frames: both in the same frame.
/// Error: as measureOvershoot, with 1000 samples a shape.
Overshoot unionOvershootOf(const std::vector<PosedShape>& shapes, const TriangleMesh& mesh);

/// The inner sphere with the largest radius and the inner capsule with the largest volume among
/// these elements, each proven to lie inside its element. Frames: the link's.
InnerShapes innerShapesOf(const Link& link, const std::vector<std::size_t>& elements);

}  // namespace collision_monitor::fit_tool
