// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/mesh_files/mesh_builder.h"

#include <limits>
#include <stdexcept>
#include <string>

#include "geometry/meshes/flat_triangles.h"

namespace collision_monitor {
MeshBuilder::MeshBuilder(std::size_t likely_triangles) {
  // Euler: a closed surface has half as many vertices as triangles.
  const std::size_t likely_vertices = likely_triangles / 2 + 2;
  mesh_.triangles.reserve(likely_triangles);
  mesh_.vertices.reserve(likely_vertices);
  table_.reserve(likely_vertices);
}

std::uint32_t MeshBuilder::addVertex(const Eigen::Vector3d& vertex) {
  if (!vertex.allFinite()) {
    throw std::runtime_error("vertex " + std::to_string(mesh_.vertices.size()) +
                             " of the mesh is not finite");
  }
  if (mesh_.vertices.size() >= std::numeric_limits<std::uint32_t>::max()) {
    throw std::runtime_error("more vertices than a mesh can index");
  }
  const auto own = static_cast<std::uint32_t>(mesh_.vertices.size());
  const std::uint32_t first = table_.firstEqual(vertex, own, mesh_.vertices);
  if (first == own) {
    // Adding 0 turns -0 into 0, so the result does not depend on the order of equal vertices.
    mesh_.vertices.emplace_back(vertex + Eigen::Vector3d::Zero());
  }
  return first;
}

void MeshBuilder::addTriangle(const std::array<std::uint32_t, 3>& corners) {
  const auto& vertices = mesh_.vertices;
  const bool is_flat = hasNoArea(vertices[corners[0]], vertices[corners[1]], vertices[corners[2]]);
  (is_flat ? flat_ : mesh_.triangles).push_back(corners);
}

TriangleMesh MeshBuilder::takeMesh() {
  addFlatTriangles(std::move(flat_), mesh_);
  return std::move(mesh_);
}

}  // namespace collision_monitor
