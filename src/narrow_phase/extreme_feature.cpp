// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/extreme_feature.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

// What of a core is level across a direction.
struct LevelFeature {
  int dimension{0};                  ///< 0 a vertex, 1 an edge, 2 a face
  Vector3d along{Vector3d::Zero()};  ///< of an edge; any length
};

LevelFeature levelOfBox(const Vector3d& half_extents, const Vector3d& direction) noexcept {
  LevelFeature level;
  for (Eigen::Index k = 0; k < 3; ++k) {
    if (half_extents[k] > 0.0 && std::abs(direction[k]) <= kLevelSine) {
      ++level.dimension;
      level.along = Vector3d::Unit(k);
    }
  }
  return level;
}

LevelFeature levelOfCylinder(const Vector3d& direction) noexcept {
  if (direction.head<2>().norm() <= kLevelSine) {
    return {2, Vector3d::Zero()};
  }
  return {std::abs(direction.z()) <= kLevelSine ? 1 : 0, Vector3d::UnitZ()};
}

LevelFeature levelOfHull(const ConvexHull& hull, std::uint32_t vertex,
                         const Vector3d& direction) noexcept {
  LevelFeature level;
  for (const ConvexHull::Fan& fan : hull.fansOf(vertex)) {
    for (std::size_t i = 0; i < fan.vertex.size(); ++i) {
      if (i > 0 && fan.vertex[i] == fan.vertex[0]) {
        break;
      }
      const Vector3d along = hull.vertices()[fan.vertex[i]] - hull.vertices()[vertex];
      const double fall = along.dot(direction);
      if (fall * fall <= kLevelSine * kLevelSine * along.squaredNorm()) {
        level.dimension = std::min(level.dimension + 1, 2);
        level.along = along;
      }
    }
  }
  return level;
}

LevelFeature levelOf(const ExtremeFeature& extreme) noexcept {
  switch (extreme.core.kind) {
    case ConvexCore::Kind::box:
      return levelOfBox(extreme.core.half_extents, extreme.direction);
    case ConvexCore::Kind::cylinder:
      return levelOfCylinder(extreme.direction);
    case ConvexCore::Kind::hull:
      return levelOfHull(*extreme.core.hull, extreme.vertex, extreme.direction);
    case ConvexCore::Kind::triangle:
      return {};
  }
  return {};
}

}  // namespace

ExtremeFeature extremeOf(const ConvexCore& core, const Vector3d& direction,
                         std::uint32_t vertex) noexcept {
  ExtremeFeature extreme{core, direction, vertex, 0.0, false};
  switch (core.kind) {
    case ConvexCore::Kind::box:
      extreme.reach = core.half_extents.dot(direction.cwiseAbs());
      extreme.may_be_level = direction.cwiseAbs().minCoeff() <= kLevelSine;
      break;
    case ConvexCore::Kind::cylinder:
      extreme.reach = core.half_extents.x() * direction.head<2>().norm() +
                      core.half_extents.z() * std::abs(direction.z());
      extreme.may_be_level = levelOfCylinder(direction).dimension > 0;
      break;
    case ConvexCore::Kind::hull: {
      const ConvexHull& hull = *core.hull;
      extreme.reach = direction.dot(hull.vertices()[vertex]);
      double beside = hull.reachBeside(direction, vertex);
      if (beside > extreme.reach || !hull.canClimb()) {
        extreme.vertex = hull.supportVertex(direction, vertex);
        extreme.reach = direction.dot(hull.vertices()[extreme.vertex]);
        beside = hull.reachBeside(direction, extreme.vertex);
      }
      extreme.may_be_level = beside >= extreme.reach - 2.0 * kLevelSine * hull.boundingRadius();
      break;
    }
    case ConvexCore::Kind::triangle:
      extreme.reach = supportPoint(core, direction, vertex).dot(direction);
      break;
  }
  return extreme;
}

bool areLevel(const ExtremeFeature& of_a, const Eigen::Matrix3d& world_from_a,
              const ExtremeFeature& of_b, const Eigen::Matrix3d& world_from_b) noexcept {
  if (!of_a.may_be_level || !of_b.may_be_level) {
    return false;
  }
  const LevelFeature level_a = levelOf(of_a);
  const LevelFeature level_b = levelOf(of_b);
  if (level_a.dimension != 1 || level_b.dimension != 1) {
    return level_a.dimension > 0 && level_b.dimension > 0;
  }
  const Vector3d along_a = world_from_a * level_a.along;
  const Vector3d along_b = world_from_b * level_b.along;
  const double lengths = along_a.squaredNorm() * along_b.squaredNorm();
  return along_a.cross(along_b).squaredNorm() <= kLevelSine * kLevelSine * lengths;
}

}  // namespace collision_monitor
