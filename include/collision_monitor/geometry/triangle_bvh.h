// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "collision_monitor/geometry/bounds.h"
#include "collision_monitor/geometry/triangle_mesh.h"

namespace collision_monitor {

/// The point of a mesh that is nearest to a query point.
struct NearestPoint {
  static constexpr std::uint32_t kNone = 0xffffffffu;

  double distance{std::numeric_limits<double>::infinity()};  ///< [m], never negative
  Eigen::Vector3d point{Eigen::Vector3d::Zero()};
  std::uint32_t leaf_triangle{kNone};  ///< into TriangleBvh::triangles; kNone: none is so near
};

/// A static hierarchy of axis-aligned boxes over the triangles of a mesh. A mesh without triangles
/// is taken as its vertices.
///
/// Built once, top-down, split at the median of the centroids along the longest axis; queries
/// neither allocate nor throw and may run at the same time.
/// Frames: that of the mesh. Units: metres.
/// Source: Ericson, "Real-Time Collision Detection" (2005), sections 6.2 and 6.6 (depth-first
/// order).
class TriangleBvh {
 public:
  using Triangle = std::array<Eigen::Vector3d, 3>;

  /// Children of an inner node stand at `first` and `first + 1`; a leaf holds `count` triangles
  /// from `first` on.
  struct Node {
    Aabb bounds;
    std::uint32_t first{0};
    std::uint32_t count{0};  ///< 0 for an inner node
  };

  /// @throws std::invalid_argument when the mesh has no vertices, one is not finite, or a triangle
  /// names a vertex that is not there.
  explicit TriangleBvh(const TriangleMesh& mesh);

  /// The nearest point of the surface, if it is nearer than `start.distance`; else `start`. A good
  /// `start`, such as a triangle nearest to a neighbouring query, makes the search short.
  /// Error: the distance exceeds the least one by at most the fraction `tolerance` of it; a
  /// hundredth makes queries far from a fine mesh several times faster.
  NearestPoint nearestTo(const Eigen::Vector3d& point, const NearestPoint& start = NearestPoint{},
                         double tolerance = 0.0) const noexcept;

  /// The point of one triangle, as a `start` for nearestTo.
  NearestPoint nearestOn(std::uint32_t leaf_triangle, const Eigen::Vector3d& point) const noexcept;

  const std::vector<Node>& nodes() const noexcept { return nodes_; }
  /// In the order of the leaves.
  const std::vector<Triangle>& triangles() const noexcept { return triangles_; }

 private:
  std::vector<Node> nodes_;
  std::vector<Triangle> triangles_;
};

/// Squared distance of a point to a box, 0 inside. Units: square metres.
inline double squaredDistance(const Aabb& box, const Eigen::Vector3d& point) noexcept {
  return (box.min - point).cwiseMax(point - box.max).cwiseMax(0.0).squaredNorm();
}

}  // namespace collision_monitor
