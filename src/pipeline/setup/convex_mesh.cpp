// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/setup/convex_mesh.h"

#include <algorithm>

namespace collision_monitor {

bool isSurfaceOf(const TriangleMesh& mesh, const ConvexHull& hull) {
  constexpr double kTooMuch = 1e7;
  const auto work =
      static_cast<double>(mesh.triangles.size()) * static_cast<double>(hull.faces().size());
  if (!hull.hasVolume() || work > kTooMuch) {
    return false;
  }
  double extent = 0.0;
  for (const Eigen::Vector3d& vertex : hull.vertices()) {
    extent = std::max(extent, (vertex - hull.vertices().front()).norm());
  }
  const double tolerance = kConvexTolerance * extent;
  return std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& triangle) {
    return std::any_of(hull.faces().begin(), hull.faces().end(), [&](const ConvexHull::Face& face) {
      return std::all_of(triangle.begin(), triangle.end(), [&](std::uint32_t corner) {
        return face.normal.dot(mesh.vertices[corner]) >= face.offset - tolerance;
      });
    });
  });
}

}  // namespace collision_monitor
