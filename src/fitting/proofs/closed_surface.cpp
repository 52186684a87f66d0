// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/proofs/closed_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "collision_monitor/geometry/winding.h"
#include "geometry/constants.h"
#include "geometry/meshes/triangle_sides.h"
#include "geometry/meshes/weld_vertices.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

constexpr double kFlat = 1e-12;  // volume over cubed size

TriangleMesh welded(const TriangleMesh& mesh) {
  const std::vector<std::uint32_t> first = firstEquals(mesh.vertices);
  TriangleMesh result;
  result.vertices = mesh.vertices;
  result.triangles.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    const std::array<std::uint32_t, 3> triangle{first[t[0]], first[t[1]], first[t[2]]};
    if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0]) {
      result.triangles.push_back(triangle);
    }
  }
  return result;
}

/// Whether every edge has one triangle in each direction.
bool isClosed(const TriangleMesh& mesh) {
  bool is_closed = !mesh.triangles.empty();
  forEdges(sidesOf(mesh.triangles, mesh.vertices.size()), [&](auto first, auto last) {
    is_closed = is_closed && last - first == 2 && first->is_forward != (first + 1)->is_forward;
  });
  return is_closed;
}

double volumeOf(const TriangleMesh& mesh, const Vector3d& center) {
  double volume = 0.0;
  for (const auto& t : mesh.triangles) {
    const Vector3d a = mesh.vertices[t[0]] - center;
    const Vector3d b = mesh.vertices[t[1]] - center;
    const Vector3d c = mesh.vertices[t[2]] - center;
    volume += a.dot(b.cross(c)) / 6.0;
  }
  return volume;
}

}  // namespace

std::optional<TriangleMesh> closedSurface(const TriangleMesh& mesh) {
  TriangleMesh surface = welded(mesh);
  if (!isClosed(surface)) {
    return std::nullopt;
  }
  Vector3d low = surface.vertices[surface.triangles[0][0]];
  Vector3d high = low;
  for (const auto& triangle : surface.triangles) {
    for (const auto corner : triangle) {
      low = low.cwiseMin(surface.vertices[corner]);
      high = high.cwiseMax(surface.vertices[corner]);
    }
  }
  const double size = (high - low).norm();
  const double volume = volumeOf(surface, 0.5 * low + 0.5 * high);
  if (!(std::abs(volume) > kFlat * size * size * size)) {
    return std::nullopt;
  }
  if (volume < 0.0) {
    for (auto& triangle : surface.triangles) {
      std::swap(triangle[1], triangle[2]);
    }
  }
  return surface;
}

double windingNumber(const TriangleBvh& surface, const Vector3d& point) noexcept {
  SolidAngles angles(point);
  for (const auto& triangle : surface.triangles()) {
    angles.add(triangle);
  }
  return angles.sum() / (4.0 * kPi);
}

}  // namespace collision_monitor
