// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/meshes/check_mesh.h"

#include <sstream>
#include <stdexcept>
#include <string>

namespace collision_monitor {
namespace {

void checkVertices(const TriangleMesh& mesh, double most) {
  if (mesh.vertices.empty()) {
    throw std::invalid_argument("mesh: no vertices; at least one is needed");
  }
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Eigen::Vector3d& vertex = mesh.vertices[i];
    if (!(vertex.array().abs() <= most).all()) {
      std::ostringstream message;
      message << "mesh: vertex " << i << " is (" << vertex.x() << ", " << vertex.y() << ", "
              << vertex.z() << "); coordinates up to " << most << " are accepted";
      throw std::invalid_argument(message.str());
    }
  }
}

void checkTriangles(const TriangleMesh& mesh) {
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (const auto corner : mesh.triangles[i]) {
      if (corner >= mesh.vertices.size()) {
        throw std::invalid_argument("mesh: triangle " + std::to_string(i) + " names vertex " +
                                    std::to_string(corner) + "; there are " +
                                    std::to_string(mesh.vertices.size()) + ", counted from 0");
      }
    }
  }
}

}  // namespace

void checkMesh(const TriangleMesh& mesh, double most) {
  checkVertices(mesh, most);
  checkTriangles(mesh);
}

}  // namespace collision_monitor
