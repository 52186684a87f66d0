// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "collision_monitor/geometry/bounds.h"
#include "collision_monitor/geometry/ids.h"
#include "collision_monitor/geometry/triangle_mesh.h"

namespace collision_monitor {

/// The point of a mesh that is nearest to a query point.
struct NearestPoint {
  double distance{std::numeric_limits<double>::infinity()};  ///< [m], never negative
  Eigen::Vector3d point{Eigen::Vector3d::Zero()};            ///< [m] the nearest point itself
  std::uint32_t leaf_triangle{kNone};  ///< in TriangleBvh::triangles; kNone: none is so near
};

/// A static hierarchy of axis-aligned boxes over the triangles of a mesh. A mesh without triangles
/// is treated as its vertices.
///
/// Each node has four children, whose boxes stand side by side in single precision and are tested
/// together. Each leaf has one triangle. Boxes are rounded outward, so no triangle is lost. Every
/// distance that counts is computed in doubles.
/// Built once, top-down, by the surface area heuristic; queries neither allocate nor throw and may
/// run at the same time.
/// Frames: that of the mesh. Units: metres.
/// Source: Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies" (2007), for the
/// bins; Dammertz, Hanika, Keller, "Shallow Bounding Volume Hierarchies for Fast SIMD Ray Tracing
/// of Incoherent Rays" (2008), for four children side by side.
class TriangleBvh {
 public:
  using Triangle = std::array<Eigen::Vector3d, 3>;  ///< three corners, [m]
  using Lanes = Eigen::Array<float, 4, 1>;          ///< one number for each child of a node

  /// Four children side by side.
  struct Node {
    static constexpr std::uint32_t kLeaf = 0x80000000u;  ///< child: kLeaf + leaf triangle

    std::array<Lanes, 3> low;   ///< unit frame; lanes without a child are infinitely far away
    std::array<Lanes, 3> high;  ///< upper corners, likewise
    std::array<std::uint32_t, 4> child;  ///< a node, or kLeaf + a leaf triangle
  };

  /// The unit frame, in which the mesh lies between -1 and 1.
  struct UnitFrame {
    Eigen::Vector3d center{Eigen::Vector3d::Zero()};  ///< [m] its origin, in the frame of the mesh
    double scale{1.0};                                ///< [m] of one unit
  };

  /// @throws std::invalid_argument as checkMesh.
  explicit TriangleBvh(const TriangleMesh& mesh);

  /// The nearest point of the surface if it is nearer than `start.distance`, otherwise `start`. A
  /// good `start`, such as a triangle nearest to a neighbouring query, makes the search short.
  /// Error: the distance exceeds the least one by at most the fraction `tolerance` of it, plus
  /// 1e-15 of the mesh's size. A tolerance of 0.01 makes queries far from a fine mesh several times
  /// faster.
  NearestPoint nearestTo(const Eigen::Vector3d& point, const NearestPoint& start = NearestPoint{},
                         double tolerance = 0.0) const noexcept;

  /// The nearest point of one triangle, as a `start` for nearestTo.
  NearestPoint nearestOn(std::uint32_t leaf_triangle, const Eigen::Vector3d& point) const noexcept;

  /// The box of all triangles.
  const Aabb& bounds() const noexcept { return bounds_; }
  /// The triangles in the order of the leaves.
  const std::vector<Triangle>& triangles() const noexcept { return triangles_; }
  /// All nodes, the root first.
  const std::vector<Node>& nodes() const noexcept { return nodes_; }
  /// How the boxes of the nodes are placed and scaled.
  const UnitFrame& unitFrame() const noexcept { return unit_frame_; }

 private:
  Aabb bounds_;
  UnitFrame unit_frame_;
  std::vector<Node> nodes_;
  std::vector<Triangle> triangles_;
};

}  // namespace collision_monitor
