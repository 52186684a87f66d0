// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/geometry/hull.h"

namespace collision_monitor {

/// The triangles of a hull gathered into flat faces, and the edges between these.
struct HullFaces {
  std::vector<ConvexHull::Face> faces;
  std::vector<ConvexHull::Edge> edges;
  std::vector<std::vector<std::uint32_t>> rings;  ///< by face: its corners, counter-clockwise
};

/// Each face grows from its largest triangle over neighbours that lie in that one's plane, so
/// that slivers in a flat face do not add normals of their own, which would be mostly rounding.
/// Where the faces of a solid leave gaps or fold, as slivers might, there are no edges: who asks
/// for them needs all.
/// @pre `mesh` is a hull of convexHullOf; `extent` is its size.
HullFaces gatherFaces(const TriangleMesh& mesh, double extent);

}  // namespace collision_monitor
