// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "collision_monitor/geometry/triangle_bvh.h"

namespace collision_monitor {

/// The few triangles that have been nearest to something so far: a search looks at them often and
/// at the whole mesh seldom. In the middle of a round body every triangle is about as near as the
/// nearest, and one look at the mesh is a look at all of it.
class NearTriangles {
 public:
  explicit NearTriangles(const TriangleBvh& mesh) : mesh_(mesh) {}

  /// Among the triangles known so far; an upper bound of the distance to the mesh.
  NearestPoint nearestKnown(const Eigen::Vector3d& point) const noexcept {
    NearestPoint nearest;
    for (const auto triangle : known_) {
      const NearestPoint found = mesh_.nearestOn(triangle, point);
      nearest = found.distance < nearest.distance ? found : nearest;
    }
    return nearest;
  }

  /// Among all, and known from now on. Error: up to the fraction `tolerance` too far.
  NearestPoint nearestOfAll(const Eigen::Vector3d& point, double tolerance) {
    NearestPoint nearest = mesh_.nearestTo(point, nearestKnown(point), tolerance);
    if (std::find(known_.begin(), known_.end(), nearest.leaf_triangle) == known_.end()) {
      known_.push_back(nearest.leaf_triangle);
    }
    return nearest;
  }

 private:
  const TriangleBvh& mesh_;
  std::vector<std::uint32_t> known_;
};

}  // namespace collision_monitor
