// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/meshes/used_vertices.h"

#include <algorithm>

#include "collision_monitor/geometry/ids.h"

namespace collision_monitor {

std::optional<TriangleMesh> withoutUnusedVertices(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> numbers(mesh.vertices.size(), kNone);
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      numbers[corner] = 0;
    }
  }
  if (mesh.triangles.empty() || std::find(numbers.begin(), numbers.end(), kNone) == numbers.end()) {
    return std::nullopt;
  }
  TriangleMesh used;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i] != kNone) {
      numbers[i] = static_cast<std::uint32_t>(used.vertices.size());
      used.vertices.push_back(mesh.vertices[i]);
    }
  }
  used.triangles = mesh.triangles;
  for (auto& triangle : used.triangles) {
    for (std::uint32_t& corner : triangle) {
      corner = numbers[corner];
    }
  }
  return used;
}

}  // namespace collision_monitor
