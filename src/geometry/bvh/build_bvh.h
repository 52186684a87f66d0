// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/geometry/triangle_bvh.h"

namespace collision_monitor {

/// Nodes deeper than this split by count and no longer by area, so that a path has at most
/// kSplitByArea + 16 nodes whatever the mesh.
constexpr std::size_t kSplitByArea = 24;
constexpr std::size_t kMaxBvhDepth = kSplitByArea + 16;

/// How much wider boxes are made than the triangles, in the unit frame: more than rounding to
/// single precision moves the box, and a query point within 4 of the origin, together.
constexpr float kBvhPadding = 1e-6f;

/// Builds the nodes over the triangles and sorts these into the order of the leaves.
/// @pre at least one triangle, at most 2^31.
std::vector<TriangleBvh::Node> buildBvh(const TriangleBvh::UnitFrame& frame,
                                        std::vector<TriangleBvh::Triangle>& triangles);

}  // namespace collision_monitor
