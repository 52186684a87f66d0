// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/gjk/support_plane.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

// The part of a core that is level across a direction.
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
  const Vector3d& corner = hull.vertices()[vertex];
  const double least_reach =
      corner.dot(direction) - 2.0 * kLevelSine * hull.boundingRadius();  // edges: 2 radii at most
  for (const ConvexHull::Fan& fan : hull.fansOf(vertex)) {
    const auto reaches = fan.reaches(direction);
    for (std::size_t i = 0; i < fan.vertex.size(); ++i) {
      if (i > 0 && fan.vertex[i] == fan.vertex[0]) {
        break;
      }
      if (reaches[static_cast<Eigen::Index>(i)] < least_reach) {
        continue;
      }
      const Vector3d along = hull.vertices()[fan.vertex[i]] - corner;
      const double fall = along.dot(direction);
      if (fall * fall <= kLevelSine * kLevelSine * along.squaredNorm()) {
        level.dimension = std::min(level.dimension + 1, 2);
        level.along = along;
      }
    }
  }
  return level;
}

LevelFeature levelOf(const PlacedCore& placed, const Vector3d& direction) noexcept {
  switch (placed.core.kind) {
    case ConvexCore::Kind::box:
      return levelOfBox(placed.core.half_extents, direction);
    case ConvexCore::Kind::cylinder:
      return levelOfCylinder(direction);
    case ConvexCore::Kind::hull:
      return levelOfHull(*placed.core.hull, placed.vertex, direction);
    case ConvexCore::Kind::triangle:
    case ConvexCore::Kind::part:
      return {};
  }
  return {};
}

}  // namespace

Vector3d cornerOf(const PlacedCore& placed, const Vector3d& direction) noexcept {
  return placed.core.kind == ConvexCore::Kind::hull
             ? placed.core.hull->vertices()[placed.vertex]
             : supportPoint(placed.core, direction, placed.vertex);
}

ExtremeFeature extremeOfPrimitive(const ConvexCore& core, const Vector3d& direction) noexcept {
  const Vector3d& half_extents = core.half_extents;
  switch (core.kind) {
    case ConvexCore::Kind::box:
      return extremeOfBox(half_extents, direction);
    case ConvexCore::Kind::cylinder: {
      const double across = direction.head<2>().norm();
      const double up = std::abs(direction.z());
      return {0, half_extents.x() * across + half_extents.z() * up,
              std::min(across, up) <= kLevelSine};
    }
    case ConvexCore::Kind::hull:
    case ConvexCore::Kind::triangle:
    case ConvexCore::Kind::part:
      break;
  }
  std::uint32_t none = 0;
  return {0, supportPoint(core, direction, none).dot(direction), false};
}

bool areLevel(const PlacedPair& pair, const SupportPlanes& planes) noexcept {
  const LevelFeature of_a = levelOf(pair.a, directionIn(pair.a, planes.normal));
  const LevelFeature of_b = levelOf(pair.b, -directionIn(pair.b, planes.normal));
  if (of_a.dimension != 1 || of_b.dimension != 1) {
    return of_a.dimension > 0 && of_b.dimension > 0;
  }
  const Vector3d along_a = pair.a.world_from_core.rotation * of_a.along;
  const Vector3d along_b = pair.b.world_from_core.rotation * of_b.along;
  const double lengths = along_a.squaredNorm() * along_b.squaredNorm();
  return along_a.cross(along_b).squaredNorm() <= kLevelSine * kLevelSine * lengths;
}

ConvexWarmStart::Ends cornersOf(const PlacedPair& pair, const SupportPlanes& planes) noexcept {
  return {cornerOf(pair.a, directionIn(pair.a, planes.normal)),
          cornerOf(pair.b, -directionIn(pair.b, planes.normal))};
}

}  // namespace collision_monitor
