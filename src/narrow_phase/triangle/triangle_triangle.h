// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>

#include "collision_monitor/geometry/triangle.h"

/// Triangle against triangle: the innermost query of two meshes.
///
/// Frames: one for all. Units: metres. Triangles are closed sets: touching ones overlap.
/// Limits: triangles without area are legal. They stand for the segment or point that they cover.
namespace collision_monitor {

/// Two points, one on each of two things, and their distance.
struct PointPair {
  double squared_distance{std::numeric_limits<double>::infinity()};  ///< [m^2], never negative
  Eigen::Vector3d on_a{Eigen::Vector3d::Zero()};
  Eigen::Vector3d on_b{Eigen::Vector3d::Zero()};
};

/// True if the triangles share a point.
///
/// Error: correct for triangles that are apart, or reach into each other, by more than 1e-14 of
/// their size. Corners that near to the other's plane count as in it.
/// Source: Moeller, "A Fast Triangle-Triangle Intersection Test" (1997), for the plane side tests
/// and the intervals on the planes' common line. Departure: separating lines along the six edges
/// decide the coplanar case, and nearestPoints takes triangles too thin to have a plane.
bool overlap(const Triangle& a, const Triangle& b) noexcept;

/// Finds the two nearest points, if they are nearer than `start`; else returns `start`.
///
/// If the triangles share a point, the squared distance is 0 or the rounding of it.
/// Error: both points are on their triangles, so the distance is never too small but for rounding.
/// It is too large by a few ulps of the coordinates at most, for needles too.
/// Source: triangles that are apart are nearest at a corner and a face or at two edges:
/// Larsen, Gottschalk, Lin, Manocha, "Fast Proximity Queries with Swept Sphere Volumes" (1999),
/// appendix; edges as in closestParameters of src/narrow_phase/closed_form/closest_points.h.
PointPair nearestPoints(const Triangle& a, const Triangle& b,
                        const PointPair& start = PointPair{}) noexcept;

/// The nearest points of two triangles, or a lower bound of their distance.
struct TriangleDistance {
  PointPair nearest;
  double squared_bound;  ///< [m^2] square of a lower bound of the distance
  /// From A to B, of any length: along it they are that far apart; 0: none is known.
  Eigen::Vector3d direction{Eigen::Vector3d::Zero()};
  std::uint32_t visits{1};  ///< cost in nodes opened; 1 if the bound sufficed
};

/// As nearestPoints, but stops if the direction of `start`, or the plane of a triangle, proves that
/// they are `squared_cutoff` apart.
/// @param squared_cutoff [m^2] at most that of `start`.
TriangleDistance boundedDistance(const Triangle& a, const Triangle& b, const PointPair& start,
                                 double squared_cutoff) noexcept;

}  // namespace collision_monitor
