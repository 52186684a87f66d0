// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/mesh_files/mesh_builder.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

namespace collision_monitor {
namespace {

/// A triangle whose height is below this part of its longest edge is a line within the precision of
/// its numbers (float, 6e-8). Its normal is noise.
constexpr double kFlatness = 1e-12;

bool hasArea(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const double longest_squared =
      std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return (b - a).cross(c - a).norm() > kFlatness * longest_squared;
}

}  // namespace

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
  if (hasArea(vertices[corners[0]], vertices[corners[1]], vertices[corners[2]])) {
    mesh_.triangles.push_back(corners);
  }
}

}  // namespace collision_monitor
