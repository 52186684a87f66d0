// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "collision_monitor/geometry/triangle_mesh.h"
#include "geometry/meshes/weld_vertices.h"

namespace collision_monitor {

/// Builds a mesh vertex by vertex and merges equal vertices.
class MeshBuilder {
 public:
  MeshBuilder() = default;
  /// Reserves memory for a closed surface with this many triangles. More may be added.
  explicit MeshBuilder(std::size_t likely_triangles);

  /// @throws std::runtime_error if the vertex is not finite.
  std::uint32_t addVertex(const Eigen::Vector3d& vertex);

  /// Triangles without area come last in the mesh, as addFlatTriangles adds them.
  void addTriangle(const std::array<std::uint32_t, 3>& corners);

  /// Returns the mesh. The builder cannot be used afterwards.
  TriangleMesh takeMesh();

 private:
  TriangleMesh mesh_;
  VertexTable table_;
  std::vector<std::array<std::uint32_t, 3>> flat_;  ///< triangles without area
};

}  // namespace collision_monitor
