// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/fitting/posed_shape.h"

#include <algorithm>
#include <limits>

namespace collision_monitor {

Shape grown(const Shape& shape, double growth) {
  struct {
    double growth;
    Shape operator()(const Sphere& s) const { return Sphere{s.radius + growth}; }
    Shape operator()(const Capsule& s) const { return Capsule{s.half_length, s.radius + growth}; }
    Shape operator()(const Box& s) const {
      return Box{s.half_extents + Eigen::Vector3d::Constant(growth)};
    }
    Shape operator()(const RoundedBox& s) const {
      return RoundedBox{s.half_extents, s.radius + growth};
    }
  } grow{growth};
  return std::visit(grow, shape);
}

double excessOver(const PosedShape& fit, const Points& points) noexcept {
  const Pose& pose = fit.geometry_from_body;
  double excess = -std::numeric_limits<double>::infinity();
  for (const auto& point : points) {
    const Eigen::Vector3d in_body = pose.rotation.transpose() * (point - pose.translation);
    excess = std::max(excess, signedDistanceTo(fit.shape, in_body));
  }
  return excess;
}

}  // namespace collision_monitor
