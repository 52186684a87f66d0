// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>

#include "collision_monitor/narrow_phase/convex_workspace.h"

namespace collision_monitor {

/// Up to four points of the difference B - A, reduced to those that span the nearest point of
/// their hull to the origin.
struct Simplex {
  std::array<SupportVertex, 4> vertices;
  std::array<double, 4> weights;  ///< of the nearest point; positive, sum 1
  int size{0};
  bool contains_origin{false};
  Eigen::Vector3d nearest{Eigen::Vector3d::Zero()};
  double distance{std::numeric_limits<double>::infinity()};  ///< of `nearest`
  /// Unit, from the origin to the nearest point. Where that is nearer than the feature is wide, it
  /// is the feature's own normal, which is sharp however near the origin is.
  Eigen::Vector3d normal{Eigen::Vector3d::UnitX()};

  Eigen::Vector3d pointOnA() const noexcept;  ///< in A's frame
  Eigen::Vector3d pointOnB() const noexcept;  ///< in B's frame
};

/// The point of one feature's inside that is nearest to the origin.
struct NearestOnSimplex {
  double squared{std::numeric_limits<double>::infinity()};  ///< its squared distance
  Eigen::Vector3d point;
  Eigen::Vector3d outward;     ///< any length and sense: the point's direction or the feature's own
  std::array<int, 3> corners;  ///< ascending
  std::array<double, 3> weights;
  int size{0};
};

/// Triangles of which the square of the sine is not above this are slivers, whose normals could be
/// mostly rounding.
constexpr double kLeastSineSquared = 1e-6;

/// The same of two or three points.
bool nearestInsideSpan(const std::array<Eigen::Vector3d, 4>& points, int count,
                       NearestOnSimplex& nearest) noexcept;

/// Of the vertex, edge or triangle that the first `count` points span.
/// @return false when some of them are not needed or hardly span, or there are not one to three.
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

/// Of all that the first `count` points, three at most, span.
NearestOnSimplex nearestOfAll(const std::array<Eigen::Vector3d, 4>& points, int count) noexcept;

/// Of all that the points up to `newest` span together with it. An origin inside of four points is
/// not told from one outside.
NearestOnSimplex nearestWith(const std::array<Eigen::Vector3d, 4>& points, int newest) noexcept;

/// Unit; see Simplex::normal. Zero where there is none.
inline Eigen::Vector3d normalOf(const NearestOnSimplex& nearest) noexcept {
  const double length = nearest.outward.norm();
  if (!(length > 0.0)) {
    return Eigen::Vector3d::Zero();
  }
  const double sense = nearest.outward.dot(nearest.point) < 0.0 ? -1.0 : 1.0;
  return sense / length * nearest.outward;
}

/// Takes the first `count` vertices as they are, if the point nearest to the origin is inside what
/// they span: where a search begins that moved little since the last.
/// @return false, with the simplex still empty, when it is not.
/// @pre the simplex is empty but for these vertices.
bool spanAll(int count, Simplex& simplex) noexcept;

/// Adds a vertex, finds the new nearest point and drops what does not span it.
///
/// The point is chosen among all features that the new vertex takes part in by the length of
/// what is really a combination of vertices, so that a sliver's wrong normal cannot pass for a
/// short distance, and a step that brings nothing is seen as one.
/// Source: Ericson, "Real-Time Collision Detection" (2005), section 5.1.5 and 9.5. Departs from it
/// in comparing features instead of walking Voronoi regions, whose planes slivers spoil.
/// @return false, with the simplex as it was, when the vertex brings nothing nearer.
bool insert(const SupportVertex& vertex, Simplex& simplex) noexcept;

}  // namespace collision_monitor
