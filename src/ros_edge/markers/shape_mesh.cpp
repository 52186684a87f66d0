// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/markers/shape_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "geometry/constants.h"

namespace collision_monitor {
namespace {

/// Lines of latitude and longitude. A line between two quarters occurs twice, once in each, because
/// the core's extent separates them.
struct Grid {
  std::uint32_t steps;  // per quarter circle

  std::uint32_t quarter() const { return steps + 1; }  // lines of one quarter
  std::uint32_t rows() const { return 2 * quarter(); }
  std::uint32_t columns() const { return 4 * quarter(); }
  double angleAt(std::uint32_t line) const {
    const std::uint32_t turned = line / quarter();
    return 0.5 * kPi * (turned + static_cast<double>(line % quarter()) / steps);
  }
};

/// For small circles, few steps keep the chords close.
Grid gridFor(double radius) {
  constexpr double kFewest = 2.0;
  constexpr double kMost = 4.0;
  constexpr double kNear = 2e-3;  // [m]
  const double half_step = std::acos(1.0 - std::min(1.0, kNear / radius));
  const double steps = std::ceil(0.25 * kPi / half_step);
  return {static_cast<std::uint32_t>(std::max(kFewest, std::min(kMost, steps)))};
}

double sideOf(bool is_positive) { return is_positive ? 1.0 : -1.0; }

/// A sphere's grid of latitudes and longitudes, cut into octants that the core separates.
void addVertices(const Grid& grid, const Eigen::Vector3d& half_extents, double radius,
                 TriangleMesh& mesh) {
  for (std::uint32_t row = 0; row < grid.rows(); ++row) {
    const double latitude = grid.angleAt(row) - 0.5 * kPi;
    const bool is_upper = row >= grid.quarter();
    for (std::uint32_t column = 0; column < grid.columns(); ++column) {
      const double longitude = grid.angleAt(column);
      const std::uint32_t quarter = column / grid.quarter();
      const Eigen::Vector3d direction(std::cos(latitude) * std::cos(longitude),
                                      std::cos(latitude) * std::sin(longitude), std::sin(latitude));
      const Eigen::Vector3d side(sideOf(quarter == 0 || quarter == 3), sideOf(quarter < 2),
                                 sideOf(is_upper));
      mesh.vertices.emplace_back(side.cwiseProduct(half_extents) + radius * direction);
    }
  }
}

/// Skips flat triangles: quarters without a gap between them have many.
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
  const Grid grid = gridFor(radiusOf(shape));
  const std::uint32_t columns = grid.columns();
  // Chords are tangent to the surface. With corners on the surface, the enclosed geometry would
  // show through.
  const double to_corner = radiusOf(shape) / std::cos(0.25 * kPi / grid.steps);
  addVertices(grid, coreHalfExtents(shape), to_corner, mesh);
  for (std::uint32_t row = 0; row + 1 < grid.rows(); ++row) {
    for (std::uint32_t column = 0; column < columns; ++column) {
      const std::uint32_t next = (column + 1) % columns;
      addQuad({row * columns + column, row * columns + next, (row + 1) * columns + next,
               (row + 1) * columns + column},
              mesh);
    }
  }
  // All points of a quarter coincide at its pole, so the cap has one corner per quarter.
  const std::uint32_t quarter = grid.quarter();
  const std::uint32_t top = (grid.rows() - 1) * columns;
  addQuad({3 * quarter, 2 * quarter, quarter, 0}, mesh);
  addQuad({top, top + quarter, top + 2 * quarter, top + 3 * quarter}, mesh);
  return mesh;
}

}  // namespace collision_monitor
