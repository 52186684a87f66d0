// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "collision_monitor/geometry/triangle_mesh.h"

namespace collision_monitor {

/// The convex hull of a set of points. Its vertices are points of the input, unchanged, each once.
/// Its triangles are counter-clockwise seen from outside.
///
/// Frames: that of the points. Units: metres.
/// Error: a point may lie outside by the rounding of the hull's planes, about 1e-14 of the extent
/// of the set. A caller that needs a proof checks the points themselves.
/// Limits: duplicates are legal. Planar points give their polygon, triangulated on both sides (a
/// closed mesh without volume). Collinear points give their two ends, coincident points one vertex;
/// neither gives triangles. Planar and collinear mean: within 1e-12 of the extent.
/// Source: Barber, Dobkin, Huhdanpaa, "The Quickhull Algorithm for Convex Hulls" (1996), as
/// implemented by the qhull library.
/// @throws std::invalid_argument when there is no point or one is not finite.
TriangleMesh convexHullOf(const std::vector<Eigen::Vector3d>& points);

}  // namespace collision_monitor
