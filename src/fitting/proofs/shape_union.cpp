// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/proofs/shape_union.h"

#include <algorithm>
#include <limits>

#include "fitting/proofs/proof.h"

namespace collision_monitor {

double slackOf(const PosedShape& shape, const Points& points) {
  const double allowed = provenExcess(shape, points) - excessOver(shape, points);
  double extent = 0.0;
  for (const Eigen::Vector3d& point : points) {
    extent = std::max(extent, point.norm());
  }
  return 2.0 * allowed + 256.0 * std::numeric_limits<double>::epsilon() * extent;
}

ShapeUnion::ShapeUnion(const std::vector<PosedShape>& shapes, double growth, const Points& points) {
  for (const PosedShape& shape : shapes) {
    shapes_.push_back({grown(shape.shape, growth), shape.geometry_from_body});
    slacks_.push_back(slackOf(shapes_.back(), points));
  }
}

double ShapeUnion::excessOf(const Eigen::Vector3d& point) const {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    least = std::min(least, excessOver(i, point));
  }
  return least;
}

unsigned ShapeUnion::heldBy(std::size_t shape, const Corners& corners) const {
  unsigned held = 0;
  for (unsigned i = 0; i < 3; ++i) {
    held |= excessOver(shape, corners[i]) <= 0.0 ? 1U << i : 0U;
  }
  return held;
}

double ShapeUnion::reachAlong(std::size_t shape, const Eigen::Vector3d& inside,
                              const Eigen::Vector3d& outside) const {
  constexpr int kBisections = 33;
  double reach = 0.0;
  double step = 0.5;
  for (int i = 0; i < kBisections; ++i, step *= 0.5) {
    const Eigen::Vector3d point = inside + (reach + step) * (outside - inside);
    reach += excessOver(shape, point) <= 0.0 ? step : 0.0;
  }
  return reach;
}

double ShapeUnion::excessOver(std::size_t shape, const Eigen::Vector3d& point) const {
  const Pose& pose = shapes_[shape].geometry_from_body;
  const Eigen::Vector3d in_body = pose.rotation.transpose() * (point - pose.translation);
  return signedDistanceTo(shapes_[shape].shape, in_body) + slacks_[shape];
}

}  // namespace collision_monitor
