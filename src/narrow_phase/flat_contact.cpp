// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/flat_contact.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "narrow_phase/core_distance.h"
#include "narrow_phase/hull_patch.h"
#include "narrow_phase/manifold_points.h"
#include "narrow_phase/patch.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

constexpr double kLevelSine = 1e-11;

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
  for (const std::uint32_t neighbour : hull.neighboursOf(vertex)) {
    const Vector3d along = hull.vertices()[neighbour] - hull.vertices()[vertex];
    if (std::abs(along.dot(direction)) <= kLevelSine * along.norm()) {
      level.dimension = std::min(level.dimension + 1, 2);
      level.along = along;
    }
  }
  return level;
}

// `vertex` is where a hull's climb starts and ends.
LevelFeature levelOf(const ConvexCore& core, const Vector3d& direction,
                     std::uint32_t& vertex) noexcept {
  switch (core.kind) {
    case ConvexCore::Kind::box:
      return levelOfBox(core.half_extents, direction);
    case ConvexCore::Kind::cylinder:
      return levelOfCylinder(direction);
    case ConvexCore::Kind::hull:
      vertex = core.hull->supportVertex(direction, vertex);
      return levelOfHull(*core.hull, vertex, direction);
    case ConvexCore::Kind::triangle:
      return {};
  }
  return {};
}

ContactPatch patchOf(const ConvexCore& core, const Pose& pose, const Vector3d& direction) noexcept {
  switch (core.kind) {
    case ConvexCore::Kind::box:
      return extremePatch(Box{core.half_extents}, pose, direction, kLevelSine);
    case ConvexCore::Kind::cylinder:
      return extremePatch(Cylinder{core.half_extents.z(), core.half_extents.x()}, pose, direction,
                          kLevelSine);
    case ConvexCore::Kind::hull:
      return extremePatch(*core.hull, pose, direction, kLevelSine);
    case ConvexCore::Kind::triangle:
      return {};
  }
  return {};
}

bool areLevel(ConvexPair& pair, const Vector3d& normal) noexcept {
  const LevelFeature of_a = levelOf(pair.a, normal, pair.vertex_of_a);
  if (of_a.dimension == 0) {
    return false;
  }
  const Vector3d in_b = pair.a_from_b.rotation.transpose() * -normal;
  const LevelFeature of_b = levelOf(pair.b, in_b, pair.vertex_of_b);
  if (of_a.dimension == 2 || of_b.dimension != 1) {
    return of_b.dimension > 0;
  }
  const Vector3d along_b = pair.a_from_b.rotation * of_b.along;
  return of_a.along.cross(along_b).norm() <= kLevelSine * of_a.along.norm() * along_b.norm();
}

// From the witness point of A, in the plane of the contact.
Vector3d toMiddle(const ManifoldPoints& shared, const SignedDistance& cores) noexcept {
  const Vector3d across = perpendicularTo(cores.normal_a_to_b);
  const Vector3d up = cores.normal_a_to_b.cross(across);
  std::array<Eigen::Vector2d, kMaxClipped> corners;
  for (std::size_t i = 0; i < shared.size; ++i) {
    const Vector3d way = shared.points[i].point_on_a - cores.point_on_a;
    corners[i] = {across.dot(way), up.dot(way)};
  }
  const Eigen::Vector2d middle = centroidOf(corners.data(), shared.size);
  return middle.x() * across + middle.y() * up;
}

}  // namespace

void centerOnPatch(ConvexPair& pair, SignedDistance& cores) noexcept {
  const Vector3d& normal = cores.normal_a_to_b;
  if (!areLevel(pair, normal)) {
    return;
  }
  // Of a curved core the normal is known less well, so that an edge may pass for level and a face
  // beside it not: edges that do not face each other are such.
  const EdgeSlack slack{kLevelSine, kLevelSine * pair.size};
  const ManifoldPoints shared = facingPoints(
      patchOf(pair.a, Pose{}, normal), patchOf(pair.b, pair.a_from_b, -normal), normal, slack);
  if (shared.size > 0) {
    cores.point_on_a += toMiddle(shared, cores);
    cores.point_on_b = cores.point_on_a + cores.distance * normal;
  }
}

}  // namespace collision_monitor
