// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "collision_monitor/fitting/posed_shape.h"
#include "collision_monitor/geometry/triangle_mesh.h"
#include "fitting/search/pattern_lanes.h"

namespace collision_monitor {

/// The distance to a surface on a grid around it, 0 inside. For searches with thousands of queries:
/// a query of the mesh takes a hundred times as long.
///
/// Units: metres. Error: about half a spacing, a hundredth of the mesh's size; final results are
/// measured on the mesh. Beyond 0.15 of the longest side outside, distances are too large. The
/// inside is what steps of one spacing cannot reach from outside. So small holes do no harm, and a
/// mesh with a large hole has no inside.
/// Source: nearest points spread in eight sweeps, as in Zhao, "A Fast Sweeping Method for Eikonal
/// Equations" (2005); Danielsson, "Euclidean Distance Mapping" (1980).
class DistanceGrid {
 public:
  /// @pre the mesh is valid; see checkGeometry.
  explicit DistanceGrid(const TriangleMesh& mesh);

  double distanceTo(const Eigen::Vector3d& point) const noexcept {
    return spacing_ > 0.0 ? spacing_ * static_cast<double>(distanceAt(inGrid(point)))
                          : (point - low_).norm();
  }

  /// Coordinates in spacings from the first node. The fourth is 0 and fills the register.
  using Place = Eigen::Array4f;
  Place inGrid(const Eigen::Vector3d& point) const noexcept {
    Place place = Place::Zero();
    place.head<3>() = ((point - low_) * nodes_per_metre_).cast<float>();
    return place;
  }
  Eigen::Vector3d outOfGrid(const Place& place) const noexcept {
    return low_ + spacing_ * place.head<3>().matrix().cast<double>();
  }
  /// The distance in spacings.
  float distanceAt(const Place& place) const noexcept {
    const Place at = place.max(0.0f).min(last_);
    const float outside = (place - at).matrix().squaredNorm();
    const Eigen::Array4i cell = at.cast<int>();
    const Place t = at - cell.cast<float>();
    const float* corner = distance_.data() + indexOf(cell[0], cell[1], cell[2]);
    const auto next_y = static_cast<std::size_t>(size_[0]);
    const auto next_z = static_cast<std::size_t>(size_[0]) * static_cast<std::size_t>(size_[1]);
    const auto along_x = [&](const float* d) { return d[0] + t[0] * (d[1] - d[0]); };
    const auto along_y = [&](const float* d) {
      const float near = along_x(d);
      return near + t[1] * (along_x(d + next_y) - near);
    };
    const float near = along_y(corner);
    const float inner = near + t[2] * (along_y(corner + next_z) - near);
    return outside > 0.0f ? inner + std::sqrt(outside) : inner;
  }
  double nodesPerMetre() const noexcept { return nodes_per_metre_; }
  GridRows rows() const noexcept {
    return {distance_.data(), size_[0], size_[0] * size_[1], {last_[0], last_[1], last_[2]}};
  }

  /// Points of the surface, about one spacing apart.
  Points surface() const;
  double spacing() const noexcept { return spacing_; }

 private:
  std::size_t indexOf(int x, int y, int z) const noexcept {
    const auto row = static_cast<std::size_t>(z) * static_cast<std::size_t>(size_[1]) +
                     static_cast<std::size_t>(y);
    return row * static_cast<std::size_t>(size_[0]) + static_cast<std::size_t>(x);
  }
  Eigen::Vector3d nodeAt(int x, int y, int z) const noexcept {
    return low_ + spacing_ * Eigen::Vector3d(x, y, z);
  }
  void layOut(const TriangleMesh& mesh);
  void sampleSurface(const TriangleMesh& mesh);
  void markSurface();
  void sweep(const Eigen::Vector3i& direction);
  void takeNearer(std::uint32_t point, std::size_t node, const Eigen::Vector3d& at);
  void emptyInside();

  Eigen::Vector3d low_{Eigen::Vector3d::Zero()};
  double spacing_{0.0};
  double nodes_per_metre_{0.0};
  Place last_{Place::Zero()};  ///< just before the last node
  std::array<int, 3> size_{1, 1, 1};
  Points surface_;
  std::vector<std::uint32_t> nearest_;  ///< by node: index into surface_
  std::vector<float> distance_;         ///< by node, in spacings
};

}  // namespace collision_monitor
