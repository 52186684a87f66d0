// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>

#include "collision_monitor/geometry/triangle.h"
#include "geometry/based_triangle.h"
#include "narrow_phase/triangle/triangle_triangle.h"

/// The pieces of every query about a triangle. Frames: one for all. Units: metres.
namespace collision_monitor {

/// An edge as start + t * along with 0 <= t <= 1. May have no length.
struct Edge {
  Eigen::Vector3d start;
  Eigen::Vector3d along;
  double squared_length;
};

inline Edge makeEdge(const Eigen::Vector3d& start, const Eigen::Vector3d& end) noexcept {
  const Eigen::Vector3d along = end - start;
  return {start, along, along.squaredNorm()};
}

/// A triangle with what its queries share.
struct PreparedTriangle {
  Triangle corners;
  std::array<Edge, 3> edges;  ///< edge i runs from corner i to corner i + 1
  BasedTriangle based;
  Eigen::Vector3d normal;  ///< unit; 0 for a triangle too thin to have a plane

  bool hasPlane() const noexcept { return normal.squaredNorm() > 0.0; }
};

/// Measuring two triangles takes as long as opening this many nodes.
constexpr std::uint32_t kVisitsToMeasure = 3;

PreparedTriangle prepare(const Triangle& triangle) noexcept;

/// Squared sine of edges that count as parallel.
constexpr double kParallelSquared = 1e-28;

/// Edge `a` of one triangle and edge `b` of the other.
struct EdgePair {
  std::size_t a;
  std::size_t b;
  double squared_distance;  ///< [m^2]
};

/// Finds the nearest of all nine pairs of edges. Uses the widest vector instructions of the
/// machine; all give the same bits.
/// Error: chooses by the distances of improveByEdges, up to rounding.
EdgePair nearestEdges(const PreparedTriangle& a, const PreparedTriangle& b) noexcept;

/// Replaces `best` by the nearest points of two edges if they are nearer.
void improveByEdges(const Edge& a, const Edge& b, PointPair& best) noexcept;

/// Replaces `best` by `point` and its closest point on the triangle (A), if they are nearer. Exact
/// for a closest point inside the triangle; the edges take those on its boundary.
void improveByFace(const PreparedTriangle& triangle, const Eigen::Vector3d& point,
                   PointPair& best) noexcept;

/// Replaces `best` by the point where a straight line passes through the triangle's plane and its
/// closest point on the triangle (A), if they are nearer.
void improveByPiercing(const PreparedTriangle& triangle, const Eigen::Vector3d& from,
                       const Eigen::Vector3d& to, PointPair& best) noexcept;

/// Signed height over the triangle's plane; 0 if it has none.
inline double heightOver(const PreparedTriangle& triangle, const Eigen::Vector3d& point) noexcept {
  return triangle.normal.dot(point - triangle.corners[0]);
}

/// The triangle's normal, or any unit vector if it has no plane.
inline Eigen::Vector3d anyNormalOf(const PreparedTriangle& triangle) noexcept {
  return triangle.hasPlane() ? triangle.normal : Eigen::Vector3d(Eigen::Vector3d::UnitX());
}

}  // namespace collision_monitor
