// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/convex/distance_half_space.h"

#include <algorithm>
#include <cmath>

#include "narrow_phase/closed_form/core_distance.h"

namespace collision_monitor {
namespace {

double endTowards(double half_extent, double slope) noexcept {
  return std::abs(slope) > kParallel ? std::copysign(half_extent, slope) : 0.0;
}

Eigen::Vector3d middleOfFarthest(const ConvexHull& hull,
                                 const Eigen::Vector3d& direction) noexcept {
  double farthest = direction.dot(hull.vertices()[0]);
  for (const Eigen::Vector3d& vertex : hull.vertices()) {
    farthest = std::max(farthest, direction.dot(vertex));
  }
  const double least = farthest - kParallel * hull.boundingRadius();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double count = 0.0;
  for (const Eigen::Vector3d& vertex : hull.vertices()) {
    if (direction.dot(vertex) >= least) {
      sum += vertex;
      count += 1.0;
    }
  }
  return sum / count;
}

// The middle of the core's points that are farthest in `direction` (unit).
Eigen::Vector3d middleOfFarthest(const ConvexCore& core,
                                 const Eigen::Vector3d& direction) noexcept {
  const Eigen::Vector3d& half = core.half_extents;
  switch (core.kind) {
    case ConvexCore::Kind::box:
      return {endTowards(half.x(), direction.x()), endTowards(half.y(), direction.y()),
              endTowards(half.z(), direction.z())};
    case ConvexCore::Kind::cylinder: {
      const double across = direction.head<2>().norm();
      const double scale = across > kParallel ? half.x() / across : 0.0;
      return {scale * direction.x(), scale * direction.y(), endTowards(half.z(), direction.z())};
    }
    case ConvexCore::Kind::hull:
      return middleOfFarthest(*core.hull, direction);
    case ConvexCore::Kind::triangle:
    case ConvexCore::Kind::part:
      break;  // pieces of a mesh, which is measured as a whole
  }
  return Eigen::Vector3d::Zero();
}

}  // namespace

SignedDistance distanceToHalfSpace(const ConvexCore& core, const Pose& world_from_core,
                                   const Pose& world_from_half_space) noexcept {
  const Eigen::Vector3d normal = world_from_half_space.rotation.col(2);
  const Eigen::Vector3d down = world_from_core.rotation.transpose() * -normal;
  SignedDistance cores;
  cores.point_on_a = world_from_core * middleOfFarthest(core, down);
  cores.distance = normal.dot(cores.point_on_a - world_from_half_space.translation);
  cores.normal_a_to_b = -normal;
  cores.point_on_b = cores.point_on_a + cores.distance * cores.normal_a_to_b;
  return cores;
}

}  // namespace collision_monitor
