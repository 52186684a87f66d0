// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fit_robot.h"

namespace collision_monitor::fit_tool {

/// Units: cubic metres. Of meshes the volume of the convex hull, 0 where it is flat.
double hullVolumeOf(const Geometry& geometry);

/// The volume that shapes take up together; what several share counts once.
/// Error: exact for one shape; else about 1 %, from 64 samples along each axis.
/// Units: cubic metres.
double unionVolumeOf(const std::vector<PosedShape>& shapes);

/// The overshoot of the union of shapes over a mesh in their frame.
/// Error: as measureOvershoot, with 1000 samples a shape.
Overshoot unionOvershootOf(const std::vector<PosedShape>& shapes, const TriangleMesh& mesh);

/// The inner sphere of largest radius and the inner capsule of largest volume that one of the
/// elements has, each proven to lie in its element. Frames: the link's.
InnerShapes innerShapesOf(const Link& link, const std::vector<std::size_t>& elements);

}  // namespace collision_monitor::fit_tool
