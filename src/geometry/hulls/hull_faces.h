// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/geometry/hull.h"

namespace collision_monitor {

/// The triangles of a hull merged into flat faces, and the edges between these.
struct HullFaces {
  std::vector<ConvexHull::Face> faces;
  std::vector<ConvexHull::Edge> edges;
  std::vector<std::vector<std::uint32_t>> rings;  ///< by face: its corners, counter-clockwise
};

/// Merges triangles into faces. Each face grows from its largest triangle over neighbours in the
/// plane of that triangle. So slivers in a flat face add no normals of their own, which would be
/// mostly rounding. There are no edges where slivers make the faces of a solid leave gaps or fold:
/// users of edges need all of them.
/// @pre `mesh` is a hull of convexHullOf; `extent` is its size.
HullFaces gatherFaces(const TriangleMesh& mesh, double extent);

}  // namespace collision_monitor
