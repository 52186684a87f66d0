// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/geometry/triangle_bvh.h"

namespace collision_monitor {

/// Deeper nodes split by count and not by area. So a path has at most kSplitByArea + 16 nodes for
/// every mesh.
constexpr std::size_t kSplitByArea = 24;
constexpr std::size_t kMaxBvhDepth = kSplitByArea + 16;

/// Growth of boxes in the unit frame. It is greater than the sum of two rounding errors of single
/// precision: that of the box, and that of a query point within 4 of the origin.
constexpr float kBvhPadding = 1e-6f;

/// Builds the nodes over the triangles and sorts the triangles into the order of the leaves.
/// @pre between 1 and 2^31 triangles.
std::vector<TriangleBvh::Node> buildBvh(const TriangleBvh::UnitFrame& frame,
                                        std::vector<TriangleBvh::Triangle>& triangles);

}  // namespace collision_monitor
