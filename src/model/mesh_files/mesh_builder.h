// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "collision_monitor/geometry/triangle_mesh.h"
#include "geometry/meshes/weld_vertices.h"

namespace collision_monitor {

/// Puts a mesh together vertex by vertex; equal vertices become one.
class MeshBuilder {
 public:
  MeshBuilder() = default;
  /// Makes room for a closed surface of as many triangles; there may be more.
  explicit MeshBuilder(std::size_t likely_triangles);

  /// @throws std::runtime_error if the vertex is not finite.
  std::uint32_t addVertex(const Eigen::Vector3d& vertex);

  /// Leaves out triangles without area, whose plane nobody can tell. Their
  /// corners were added all the same, so that the mesh still encloses them.
  void addTriangle(const std::array<std::uint32_t, 3>& corners);

  /// What was added; the builder cannot be used after.
  TriangleMesh takeMesh() { return std::move(mesh_); }

 private:
  TriangleMesh mesh_;
  VertexTable table_;
};

}  // namespace collision_monitor
