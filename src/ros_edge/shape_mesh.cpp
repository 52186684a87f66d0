// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/shape_mesh.h"

#include <Eigen/Geometry>
#include <cmath>

namespace collision_monitor {
namespace {

constexpr std::uint32_t kSteps = 4;  // to a quarter circle
constexpr std::uint32_t kRows = 2 * (kSteps + 1);
constexpr std::uint32_t kColumns = 4 * (kSteps + 1);

/// Angle of a grid line. The line where one quarter ends and the next begins stands twice,
/// once for each, so that the core's extent opens between the two.
double angleAt(std::uint32_t line) {
  const std::uint32_t quarter = line / (kSteps + 1);
  const std::uint32_t step = line % (kSteps + 1);
  return 0.5 * M_PI * (quarter + static_cast<double>(step) / kSteps);
}

double sideOf(bool is_positive) { return is_positive ? 1.0 : -1.0; }

/// A sphere's grid of latitudes and longitudes, cut into octants that the core pushes apart.
void addGrid(const Eigen::Vector3d& half_extents, double radius, TriangleMesh& mesh) {
  for (std::uint32_t row = 0; row < kRows; ++row) {
    const double latitude = angleAt(row) - 0.5 * M_PI;
    const bool is_upper = row > kSteps;
    for (std::uint32_t column = 0; column < kColumns; ++column) {
      const double longitude = angleAt(column);
      const std::uint32_t quarter = column / (kSteps + 1);
      const Eigen::Vector3d direction(std::cos(latitude) * std::cos(longitude),
                                      std::cos(latitude) * std::sin(longitude), std::sin(latitude));
      const Eigen::Vector3d side(sideOf(quarter == 0 || quarter == 3), sideOf(quarter < 2),
                                 sideOf(is_upper));
      mesh.vertices.emplace_back(side.cwiseProduct(half_extents) + radius * direction);
    }
  }
}

/// Flat ones are left out: quarters that are not pushed apart have many.
void addTriangle(const std::array<std::uint32_t, 3>& triangle, TriangleMesh& mesh) {
  const auto& v = mesh.vertices;
  const Eigen::Vector3d area =
      (v[triangle[1]] - v[triangle[0]]).cross(v[triangle[2]] - v[triangle[0]]);
  if (area.squaredNorm() > 1e-24) {
    mesh.triangles.push_back(triangle);
  }
}

void addQuad(const std::array<std::uint32_t, 4>& corners, TriangleMesh& mesh) {
  addTriangle({corners[0], corners[1], corners[2]}, mesh);
  addTriangle({corners[0], corners[2], corners[3]}, mesh);
}

}  // namespace

TriangleMesh surfaceOf(const Shape& shape) {
  TriangleMesh mesh;
  addGrid(coreHalfExtents(shape), radiusOf(shape), mesh);
  for (std::uint32_t row = 0; row + 1 < kRows; ++row) {
    for (std::uint32_t column = 0; column < kColumns; ++column) {
      const std::uint32_t next = (column + 1) % kColumns;
      addQuad({row * kColumns + column, row * kColumns + next, (row + 1) * kColumns + next,
               (row + 1) * kColumns + column},
              mesh);
    }
  }
  // All points of a quarter meet at its pole, so the cap has one corner a quarter.
  constexpr std::uint32_t kQuarter = kSteps + 1;
  constexpr std::uint32_t kTop = (kRows - 1) * kColumns;
  addQuad({3 * kQuarter, 2 * kQuarter, kQuarter, 0}, mesh);
  addQuad({kTop, kTop + kQuarter, kTop + 2 * kQuarter, kTop + 3 * kQuarter}, mesh);
  return mesh;
}

}  // namespace collision_monitor
