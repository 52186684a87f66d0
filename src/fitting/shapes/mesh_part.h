// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "collision_monitor/fitting/posed_shape.h"
#include "collision_monitor/geometry/bounds.h"
#include "collision_monitor/geometry/triangle_mesh.h"

namespace collision_monitor {

/// A part of a surface: numbers of whole triangles, and convex polygons that are pieces of cut
/// triangles.
struct MeshPart {
  std::vector<std::uint32_t> triangles;
  Points corners;                  ///< of all polygons, in order
  std::vector<std::uint32_t> end;  ///< polygon i ends before corners[end[i]]
};

/// The points x with normal . x = offset. Points with less are below.
struct CutPlane {
  Eigen::Vector3d normal{Eigen::Vector3d::UnitX()};
  double offset{0.0};

  double heightOf(const Eigen::Vector3d& point) const noexcept {
    return normal.dot(point) - offset;
  }
};

/// A surface that is cut into parts.
class PartedSurface {
 public:
  /// Vertices of no triangle become triangles of one point.
  /// @pre the mesh is valid and outlives this.
  explicit PartedSurface(const TriangleMesh& mesh);

  MeshPart whole() const;

  /// The vertices of the part, each once, and the corners of its polygons. Their hull holds the
  /// part, so a ball that holds them holds the part.
  Points cornersOf(const MeshPart& part);

  /// Cuts a part in two. Triangles in the plane go below.
  ///
  /// Error: both sides get the same corner on a cut edge. It lies within cutError() of a point of
  /// the edge. With that point in its place, the two sides cover the polygon exactly, wherever on
  /// the edge it is. So a ball that holds the corners of a part holds the exact part once it is
  /// grown by cutError() for each cut. Rounding may put a corner on the wrong side; this still
  /// holds.
  void split(const MeshPart& part, const CutPlane& plane, MeshPart& below, MeshPart& above) const;

  /// [m] An upper bound of the rounding error of one cut.
  double cutError() const noexcept { return cut_error_; }

 private:
  const Points& vertices_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<std::uint32_t> seen_;  ///< the number of the last call that met the vertex
  std::uint32_t calls_{0};
  double cut_error_{0.0};
};

}  // namespace collision_monitor
