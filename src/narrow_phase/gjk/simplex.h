// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>

#include "collision_monitor/narrow_phase/convex_workspace.h"

namespace collision_monitor {

/// Points of the Minkowski difference B - A, up to four: those that span the nearest point of their
/// hull to the origin.
struct Simplex {
  std::array<SupportVertex, 4> vertices;
  std::array<double, 4> weights;  ///< of the nearest point; positive, sum 1
  int size{0};
  bool contains_origin{false};
  Eigen::Vector3d nearest{Eigen::Vector3d::Zero()};
  double distance{std::numeric_limits<double>::infinity()};  ///< of `nearest`
  /// Unit, from the origin to the nearest point. If that is nearer than the feature is wide, it is
  /// the feature's own normal, which is accurate however near the origin is.
  Eigen::Vector3d normal{Eigen::Vector3d::UnitX()};

  Eigen::Vector3d pointOnA() const noexcept;  ///< in A's frame
  Eigen::Vector3d pointOnB() const noexcept;  ///< in B's frame
};

/// The point nearest to the origin inside one feature: a vertex, an edge or a triangle.
struct NearestOnSimplex {
  double squared{std::numeric_limits<double>::infinity()};  ///< its squared distance
  Eigen::Vector3d point;
  Eigen::Vector3d outward;     ///< any length and sense: the point's direction or the feature's own
  std::array<int, 3> corners;  ///< ascending
  std::array<double, 3> weights;
  int size{0};
};

/// Triangles whose squared sine is at most this are slivers. Their normals could be mostly
/// rounding.
constexpr double kLeastSineSquared = 1e-6;

/// The same as nearestOfSimplex for two or three points.
bool nearestInsideSpan(const std::array<Eigen::Vector3d, 4>& points, int count,
                       NearestOnSimplex& nearest) noexcept;

/// Finds the point nearest to the origin inside the feature of the first `count` points: a vertex,
/// an edge or a triangle.
/// @return false if fewer points suffice, or they hardly span, or there are not one to three.
inline bool nearestOfSimplex(const std::array<Eigen::Vector3d, 4>& points, int count,
                             NearestOnSimplex& nearest) noexcept {
  if (count != 1) {
    return nearestInsideSpan(points, count, nearest);
  }
  nearest.squared = points[0].squaredNorm();
  nearest.point = points[0];
  nearest.outward = points[0];
  nearest.corners[0] = 0;
  nearest.weights[0] = 1.0;
  nearest.size = 1;
  return nearest.squared < std::numeric_limits<double>::infinity();
}

/// The nearest point of all features of the first `count` points, three at most.
NearestOnSimplex nearestOfAll(const std::array<Eigen::Vector3d, 4>& points, int count) noexcept;

/// The nearest point of all features of `newest` and the points before it. Does not detect an
/// origin inside four points.
NearestOnSimplex nearestWith(const std::array<Eigen::Vector3d, 4>& points, int newest) noexcept;

/// Unit; see Simplex::normal. Zero if there is none.
inline Eigen::Vector3d normalOf(const NearestOnSimplex& nearest) noexcept {
  const double length = nearest.outward.norm();
  if (!(length > 0.0)) {
    return Eigen::Vector3d::Zero();
  }
  const double sense = nearest.outward.dot(nearest.point) < 0.0 ? -1.0 : 1.0;
  return sense / length * nearest.outward;
}

/// Takes the first `count` vertices as they are, if the point nearest to the origin is inside their
/// span. This is where a search starts if little has moved since the last.
/// @return false if it is not; the simplex then stays empty.
/// @pre the simplex is empty except for these vertices.
bool spanAll(int count, Simplex& simplex) noexcept;

/// Adds a vertex, finds the new nearest point and drops the vertices that do not span it.
///
/// Chooses the point among all features of the new vertex. Compares the lengths of actual
/// combinations of vertices, so a sliver's wrong normal cannot pass for a short distance, and a
/// step without gain is noticed.
/// Source: Ericson, "Real-Time Collision Detection" (2005), section 5.1.5 and 9.5. Departure:
/// compares features instead of walking Voronoi regions, whose planes slivers spoil.
/// @return false if the vertex brings nothing nearer; the simplex then stays as it was.
bool insert(const SupportVertex& vertex, Simplex& simplex) noexcept;

}  // namespace collision_monitor
