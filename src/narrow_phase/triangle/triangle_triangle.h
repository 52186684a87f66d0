// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>

#include "collision_monitor/geometry/triangle.h"

/// Triangle against triangle: the innermost question of two meshes.
///
/// Frames: one frame for all. Units: metres. Triangles are closed sets: touching ones overlap.
/// Limits: triangles without area are legal and stand for the segment or point that they cover.
namespace collision_monitor {

/// Two points, one on each of two things, and how far they are apart.
struct PointPair {
  double squared_distance{std::numeric_limits<double>::infinity()};  ///< [m^2], never negative
  Eigen::Vector3d on_a{Eigen::Vector3d::Zero()};
  Eigen::Vector3d on_b{Eigen::Vector3d::Zero()};
};

/// True when the triangles share a point.
///
/// Error: decided for triangles that are apart, or reach into each other, by more than 1e-14 of
/// their size; corners that near to the other's plane count as lying in it.
/// Source: Moeller, "A Fast Triangle-Triangle Intersection Test" (1997), for the plane side tests
/// and the intervals on the line that the planes share; departs from it in the coplanar case, which
/// is decided by the separating lines along the six edges, and in handing triangles too thin to
/// have a plane to nearestPoints.
bool overlap(const Triangle& a, const Triangle& b) noexcept;

/// The two nearest points, if they are nearer than `start`; else `start`.
///
/// Where the triangles share a point, the squared distance is 0 or the rounding of it.
/// Error: both points are on their triangles, so the distance is never too small but for rounding;
/// it is too large by some ulps of the coordinates, for needles too.
/// Source: the nearest points of triangles that are apart are a corner and a face or two edges:
/// Larsen, Gottschalk, Lin, Manocha, "Fast Proximity Queries with Swept Sphere Volumes" (1999),
/// appendix; edges as in closestParameters of src/narrow_phase/closed_form/closest_points.h.
PointPair nearestPoints(const Triangle& a, const Triangle& b,
                        const PointPair& start = PointPair{}) noexcept;

/// The nearest points of two triangles, or that they are no nearer than the bound.
struct TriangleDistance {
  PointPair nearest;
  double squared_bound;  ///< [m^2] of a lower bound of the distance
  /// Of any length, from A to B: along it they are as far apart; 0: none is known.
  Eigen::Vector3d direction{Eigen::Vector3d::Zero()};
  std::uint32_t visits{1};  ///< what it took, in nodes opened; 1 where the bound told enough
};

/// As nearestPoints, but looks no further where the direction of the start, or the plane of a
/// triangle, shows them to be `squared_enough` apart.
/// @param squared_enough [m^2] not more than the start.
TriangleDistance boundedDistance(const Triangle& a, const Triangle& b, const PointPair& start,
                                 double squared_cutoff) noexcept;

/// [m^2] The square of how far a direction of any length, from A to B, separates the triangles; 0
/// where it does not.
double squaredGapAlong(const Eigen::Vector3d& direction, const Triangle& a,
                       const Triangle& b) noexcept;

}  // namespace collision_monitor
