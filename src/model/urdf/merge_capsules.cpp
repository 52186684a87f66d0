// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/urdf/merge_capsules.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace collision_monitor {
namespace {

/// The spheres that close one end of a cylinder, and a radius that encloses them all.
struct Cap {
  std::vector<std::size_t> spheres;
  double radius{0.0};
};

Cap findCap(const std::vector<CollisionElement>& collisions, const Eigen::Vector3d& end,
            double radius) {
  Cap cap;
  cap.radius = radius;
  for (std::size_t i = 0; i < collisions.size(); ++i) {
    const auto* sphere = std::get_if<Sphere>(&collisions[i].geometry);
    if (sphere == nullptr || std::abs(sphere->radius - radius) > kCapsuleTolerance) {
      continue;
    }
    const double offset = (collisions[i].link_from_geometry.translation - end).norm();
    if (offset <= kCapsuleTolerance) {
      cap.spheres.push_back(i);
      // A ball about `end` that encloses a sphere whose center is off by `offset`. Offsets that are
      // only rounding are ignored: they would make an exact capsule inexact.
      const double rounding = 1e-15 * (1.0 + end.norm());
      cap.radius = std::max(cap.radius, sphere->radius + (offset > rounding ? offset : 0.0));
    }
  }
  return cap;
}

}  // namespace

void mergeCapsules(std::vector<CollisionElement>& collisions) {
  std::vector<bool> is_merged(collisions.size(), false);
  for (CollisionElement& collision : collisions) {
    const auto* cylinder = std::get_if<Cylinder>(&collision.geometry);
    if (cylinder == nullptr) {
      continue;
    }
    const Eigen::Vector3d half_axis(0.0, 0.0, cylinder->half_length);
    const Cap top = findCap(collisions, collision.link_from_geometry * half_axis, cylinder->radius);
    const Cap bottom =
        findCap(collisions, collision.link_from_geometry * -half_axis, cylinder->radius);
    if (top.spheres.empty() || bottom.spheres.empty()) {
      continue;
    }
    for (const Cap* cap : {&top, &bottom}) {
      for (const std::size_t sphere : cap->spheres) {
        is_merged[sphere] = true;
      }
    }
    collision.geometry = Capsule{cylinder->half_length, std::max(top.radius, bottom.radius)};
  }
  std::vector<CollisionElement> kept;
  for (std::size_t i = 0; i < collisions.size(); ++i) {
    if (!is_merged[i]) {
      kept.push_back(std::move(collisions[i]));
    }
  }
  collisions = std::move(kept);
}

}  // namespace collision_monitor
