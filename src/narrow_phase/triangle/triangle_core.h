// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "narrow_phase/gjk/convex_pair.h"
#include "narrow_phase/triangle/triangle_triangle.h"

namespace collision_monitor {

/// The two nearest points of a triangle (A) and a core (B), if they are nearer than `start`; else
/// `start`. The same point twice, at distance 0, where the core holds a point of the triangle.
///
/// Frames: the core's.
/// Error: as nearestPoints of two triangles; with a cylinder or a hull 1e-12 of the sizes, as GJK.
/// Source: of boxes, segments and points, features that can be nearest are counted up: corners of
/// the one to faces of the other, edge to edge; a triangle that meets a box is clipped by it:
/// Sutherland, Hodgman, "Reentrant polygon clipping" (1974).
PointPair nearestPoints(const Triangle& triangle, const ConvexCore& core,
                        const PointPair& start) noexcept;

/// As nearestPoints, but looks no further where the direction of the start, the plane of the
/// triangle or the sides of a box show them to be `squared_enough` apart.
/// @param squared_enough [m^2] not more than the start.
TriangleDistance boundedDistance(const Triangle& triangle, const ConvexCore& core,
                                 const PointPair& start, double squared_cutoff) noexcept;

/// [m^2] As of two triangles: from the triangle to the core.
double squaredGapAlong(const Eigen::Vector3d& direction, const Triangle& triangle,
                       const ConvexCore& core) noexcept;

}  // namespace collision_monitor
