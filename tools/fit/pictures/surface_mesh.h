// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/model/robot_model.h"

namespace collision_monitor::fit_tool {

/// Triangles for display and measurement: a mesh itself, or the surface of a shape, facing outward.
/// Corners are on the true surface, 96 around an axis, so triangles are at most 0.06 % of the
/// radius inside it.
/// Frames: that of the geometry.
TriangleMesh surfaceMeshOf(const Geometry& geometry);

/// The surfaces of some collision elements as one mesh in the link frame.
TriangleMesh surfaceMeshOf(const Link& link, const std::vector<std::size_t>& elements);

}  // namespace collision_monitor::fit_tool
