// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "narrow_phase/gjk/convex_pair.h"
#include "narrow_phase/triangle/triangle_triangle.h"

namespace collision_monitor {

/// Finds the two nearest points of a triangle (A) and a core (B), if they are nearer than `start`;
/// else returns `start`. Returns a point of the triangle inside the core twice, at distance 0.
///
/// Frames: the core's.
/// Error: as nearestPoints of two triangles; with a cylinder or a hull 1e-12 of the sizes, as GJK.
/// Source: for boxes, segments and points, all features that can be nearest are tried: corners of
/// one with faces of the other, edges with edges. A triangle that meets a box is clipped by it:
/// Sutherland, Hodgman, "Reentrant polygon clipping" (1974).
PointPair nearestPoints(const Triangle& triangle, const ConvexCore& core,
                        const PointPair& start) noexcept;

/// As nearestPoints, but stops if the direction of `start`, the plane of the triangle or the sides
/// of a box prove that they are `squared_cutoff` apart.
/// @param squared_cutoff [m^2] at most that of `start`.
TriangleDistance boundedDistance(const Triangle& triangle, const ConvexCore& core,
                                 const PointPair& start, double squared_cutoff) noexcept;

/// [m^2] As for two triangles, from the triangle to the core.
double squaredGapAlong(const Eigen::Vector3d& direction, const Triangle& triangle,
                       const ConvexCore& core) noexcept;

}  // namespace collision_monitor
