// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/meshes/mesh_pieces.h"

#include <numeric>

namespace collision_monitor {
namespace {

// The root that all connected vertices share. Paths to it are shortened on the way.
std::uint32_t rootOf(std::uint32_t vertex, std::vector<std::uint32_t>& parents) {
  while (parents[vertex] != vertex) {
    parents[vertex] = parents[parents[vertex]];
    vertex = parents[vertex];
  }
  return vertex;
}

}  // namespace

std::vector<Eigen::Vector3d> piecesOf(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) {
    return mesh.vertices;
  }
  std::vector<std::uint32_t> parents(mesh.vertices.size());
  std::iota(parents.begin(), parents.end(), 0U);
  for (const auto& corners : mesh.triangles) {
    parents[rootOf(corners[1], parents)] = rootOf(corners[0], parents);
    parents[rootOf(corners[2], parents)] = rootOf(corners[0], parents);
  }
  std::vector<unsigned char> is_taken(parents.size(), 0);
  std::vector<Eigen::Vector3d> pieces;
  for (const auto& corners : mesh.triangles) {
    const std::uint32_t root = rootOf(corners[0], parents);
    if (is_taken[root] == 0) {
      is_taken[root] = 1;
      pieces.push_back(mesh.vertices[root]);
    }
  }
  return pieces;
}

}  // namespace collision_monitor
