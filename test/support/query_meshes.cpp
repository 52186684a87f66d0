// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/query_meshes.h"

#include <cmath>

#include "support/sample_meshes.h"

namespace collision_monitor::test {

TriangleMesh bumpyMesh(double length, int sectors) {
  TriangleMesh mesh = sphereMesh(0.35 * length, sectors);
  for (Eigen::Vector3d& vertex : mesh.vertices) {
    const Eigen::Vector3d n = vertex.normalized();
    vertex *=
        1.0 + 0.05 * std::sin(9.0 * n.x() + 2.0) * std::sin(7.0 * n.y()) * std::cos(8.0 * n.z());
    vertex.x() /= 0.7;
  }
  return mesh;
}

TriangleMesh triangleSoup(double reach, int count, Random& random) {
  TriangleMesh mesh;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d center = randomPoint(random, reach);
    const double size = reach * std::pow(10.0, uniform(random, -2.0, -0.3));
    const Eigen::Vector3d corner = center + randomPoint(random, size);
    const Eigen::Vector3d along = randomPoint(random, size);
    const Eigen::Vector3d across = randomPoint(random, size);
    const double kind = uniform(random, 0.0, 1.0);
    const double width = kind < 0.1 ? 0.0 : (kind < 0.2 ? 1e-9 : 1.0);
    const double height = kind < 0.05 ? 0.0 : 1.0;
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back(corner);
    mesh.vertices.emplace_back(corner + height * along);
    mesh.vertices.emplace_back(corner + 0.5 * height * along + width * across);
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

}  // namespace collision_monitor::test
