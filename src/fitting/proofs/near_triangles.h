// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "collision_monitor/geometry/triangle_bvh.h"

namespace collision_monitor {

/// The few triangles that were nearest to a query so far. A search tests these often and the whole
/// mesh seldom. In the middle of a round body all triangles are about equally near, so a query of
/// the mesh visits all of it.
class NearTriangles {
 public:
  explicit NearTriangles(const TriangleBvh& mesh) : mesh_(mesh) {}

  /// The nearest point of the known triangles: an upper bound of the distance to the mesh.
  NearestPoint nearestKnown(const Eigen::Vector3d& point) const noexcept {
    NearestPoint nearest;
    for (const Known& known : known_) {
      const double reach = nearest.distance + known.radius;
      if ((point - known.center).squaredNorm() < reach * reach) {
        const NearestPoint found = mesh_.nearestOn(known.triangle, point);
        nearest = found.distance < nearest.distance ? found : nearest;
      }
    }
    return nearest;
  }

  /// The nearest point of all triangles; its triangle becomes known. Error: too far by at most the
  /// fraction `tolerance`.
  NearestPoint nearestOfAll(const Eigen::Vector3d& point, double tolerance) {
    NearestPoint nearest = mesh_.nearestTo(point, nearestKnown(point), tolerance);
    if (std::none_of(known_.begin(), known_.end(),
                     [&](const Known& known) { return known.triangle == nearest.leaf_triangle; })) {
      add(nearest.leaf_triangle);
    }
    return nearest;
  }

 private:
  struct Known {
    std::uint32_t triangle;  ///< of a leaf
    Eigen::Vector3d center;
    double radius;  ///< of a ball around it, including the rounding of distances
  };

  void add(std::uint32_t triangle) {
    constexpr double kRounding = 1e-9;
    const auto& corners = mesh_.triangles()[triangle];
    const Eigen::Vector3d center = (corners[0] + corners[1] + corners[2]) / 3.0;
    double radius = 0.0;
    for (const Eigen::Vector3d& corner : corners) {
      radius = std::max(radius, (corner - center).norm());
    }
    known_.push_back({triangle, center, radius + kRounding * mesh_.unitFrame().scale});
  }

  const TriangleBvh& mesh_;
  std::vector<Known> known_;
};

}  // namespace collision_monitor
