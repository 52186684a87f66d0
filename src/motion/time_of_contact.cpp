// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "motion/time_of_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "narrow_phase/sat/separating_axes.h"

namespace collision_monitor {
namespace {

/// When a height above a plane that changes by `climb` during the interval reaches 0.
std::optional<double> timeToFall(double height, double climb) noexcept {
  if (height <= 0.0) {
    return 0.0;
  }
  return height <= -climb ? std::optional<double>(height / -climb) : std::nullopt;
}

/// The times at which projections overlap on an axis.
struct Overlap {
  double from{0.0};
  double to{1.0};
};

/// @param center of B relative to A on the axis. @param move of it. @param reach of both together.
void narrow(double center, double move, double reach, Overlap& overlap) noexcept {
  if (move == 0.0) {
    if (std::abs(center) > reach) {
      overlap.from = std::numeric_limits<double>::infinity();
    }
    return;
  }
  const double middle = -center / move;
  const double half = reach / std::abs(move);
  overlap.from = std::max(overlap.from, middle - half);
  overlap.to = std::min(overlap.to, middle + half);
}

}  // namespace

std::optional<double> timeOfContact(const Sphere& a, const Pose& world_from_a, const Sphere& b,
                                    const Pose& world_from_b,
                                    const Eigen::Vector3d& travel) noexcept {
  const Eigen::Vector3d between = world_from_b.translation - world_from_a.translation;
  const double reach = a.radius + b.radius;
  const double beyond = between.squaredNorm() - reach * reach;
  if (beyond <= 0.0) {
    return 0.0;
  }
  const double approach = -between.dot(travel);
  if (approach <= 0.0) {
    return std::nullopt;
  }
  const double length_squared = travel.squaredNorm();
  // The distance at which the center passes. A difference of squares would lose it when grazing.
  const double aside = (between + approach / length_squared * travel).norm();
  if (aside > reach) {
    return std::nullopt;
  }
  const double root = std::sqrt(length_squared * (reach - aside) * (reach + aside));
  const double time = beyond / (approach + root);
  return time <= 1.0 ? std::optional<double>(time) : std::nullopt;
}

std::optional<double> timeOfContact(const HalfSpace& /*a*/, const Pose& world_from_a,
                                    const Sphere& b, const Pose& world_from_b,
                                    const Eigen::Vector3d& travel) noexcept {
  const Eigen::Vector3d up = world_from_a.rotation.col(2);
  const double height = up.dot(world_from_b.translation - world_from_a.translation);
  return timeToFall(height - b.radius, up.dot(travel));
}

std::optional<double> timeOfContact(const HalfSpace& /*a*/, const Pose& world_from_a, const Box& b,
                                    const Pose& world_from_b,
                                    const Eigen::Vector3d& travel) noexcept {
  const Eigen::Vector3d up = world_from_a.rotation.col(2);
  const double height = up.dot(world_from_b.translation - world_from_a.translation);
  const double reach = (world_from_b.rotation.transpose() * up).cwiseAbs().dot(b.half_extents);
  return timeToFall(height - reach, up.dot(travel));
}

std::optional<double> timeOfContact(const Box& a, const Pose& world_from_a, const Box& b,
                                    const Pose& world_from_b,
                                    const Eigen::Vector3d& travel) noexcept {
  const BoxPair pair = makeBoxPair(a.half_extents, world_from_a, b.half_extents, world_from_b);
  const Eigen::Vector3d travel_in_a = world_from_a.rotation.transpose() * travel;
  const Separations gaps = separationsOfBoxes(pair);
  Overlap overlap;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (std::isfinite(gaps.along[axis])) {  // skips parallel edges, which give no axis
      const Eigen::Vector3d direction = axisDirection(pair, axis);
      const double center = direction.dot(pair.center_of_b);
      narrow(center, direction.dot(travel_in_a), center - gaps.along[axis], overlap);
    }
  }
  return overlap.from <= overlap.to ? std::optional<double>(overlap.from) : std::nullopt;
}

}  // namespace collision_monitor
