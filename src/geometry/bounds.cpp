// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/geometry/bounds.h"

#include <limits>

namespace collision_monitor {
namespace {

// A bound takes a handful of products and sums. Each errs by at most half an ulp of its largest
// number. 16 ulps of the sum of magnitudes are well above their total.
constexpr double kRounding = 16.0 * std::numeric_limits<double>::epsilon();

}  // namespace

Aabb aabbOf(const Shape& shape, const Pose& world_from_body, double margin) noexcept {
  const Eigen::Vector3d reach = world_from_body.rotation.cwiseAbs() * coreHalfExtents(shape) +
                                Eigen::Vector3d::Constant(radiusOf(shape) + margin);
  const Eigen::Vector3d grown =
      reach + kRounding * (reach + world_from_body.translation.cwiseAbs());
  return {world_from_body.translation - grown, world_from_body.translation + grown};
}

double boundingRadius(const Shape& shape) noexcept {
  const double radius = coreHalfExtents(shape).norm() + radiusOf(shape);
  return radius + kRounding * radius;
}

}  // namespace collision_monitor
