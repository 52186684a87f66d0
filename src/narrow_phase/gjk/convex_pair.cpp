// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/gjk/convex_pair.h"

#include <algorithm>
#include <cmath>

#include "geometry/bvh/part_support.h"
#include "narrow_phase/closed_form/core_distance.h"

namespace collision_monitor {
namespace {

Eigen::Vector3d cornerOf(const Eigen::Vector3d& half_extents,
                         const Eigen::Vector3d& direction) noexcept {
  return {std::copysign(half_extents.x(), direction.x()),
          std::copysign(half_extents.y(), direction.y()),
          std::copysign(half_extents.z(), direction.z())};
}

Eigen::Vector3d rimPointOf(const Eigen::Vector3d& half_extents,
                           const Eigen::Vector3d& direction) noexcept {
  const double across = std::sqrt(direction.x() * direction.x() + direction.y() * direction.y());
  const double scale = across > 0.0 ? half_extents.x() / across : 0.0;
  return {scale * direction.x(), scale * direction.y(),
          std::copysign(half_extents.z(), direction.z())};
}

const Eigen::Vector3d& cornerOf(const Triangle& triangle,
                                const Eigen::Vector3d& direction) noexcept {
  return *std::max_element(triangle.begin(), triangle.end(),
                           [&](const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
                             return direction.dot(p) < direction.dot(q);
                           });
}

}  // namespace

Eigen::Vector3d supportPoint(const ConvexCore& core, const Eigen::Vector3d& direction,
                             std::uint32_t& vertex) noexcept {
  switch (core.kind) {
    case ConvexCore::Kind::box:
      return cornerOf(core.half_extents, direction);
    case ConvexCore::Kind::cylinder:
      return rimPointOf(core.half_extents, direction);
    case ConvexCore::Kind::hull:
      vertex = core.hull->supportVertex(direction, vertex);
      return core.hull->vertices()[vertex];
    case ConvexCore::Kind::triangle:
      return cornerOf(*core.triangle, direction);
    case ConvexCore::Kind::part:
      return farthestOfPart(*core.mesh, core.node, direction);
  }
  return Eigen::Vector3d::Zero();
}

Pose relativePose(const Pose& world_from_a, const Pose& world_from_b) noexcept {
  Pose a_from_b;
  a_from_b.rotation.noalias() = world_from_a.rotation.transpose() * world_from_b.rotation;
  a_from_b.translation.noalias() =
      world_from_a.rotation.transpose() * (world_from_b.translation - world_from_a.translation);
  return a_from_b;
}

ConvexPair makeConvexPair(const ConvexCore& a, const Pose& world_from_a, const ConvexCore& b,
                          const Pose& world_from_b) noexcept {
  ConvexPair pair;
  pair.a = a;
  pair.b = b;
  pair.a_from_b = relativePose(world_from_a, world_from_b);
  pair.size = reachOf(a) + reachOf(b) + pair.a_from_b.translation.norm();
  return pair;
}

SupportVertex differenceOf(const ConvexPair& pair, const Eigen::Vector3d& on_a,
                           const Eigen::Vector3d& on_b) noexcept {
  return {pair.a_from_b * on_b - on_a, on_a, on_b};
}

SupportVertex leastAlong(const Eigen::Vector3d& direction, ConvexPair& pair) noexcept {
  const Eigen::Vector3d on_a = supportPoint(pair.a, direction, pair.vertex_of_a);
  const Eigen::Vector3d in_b = pair.a_from_b.rotation.transpose() * -direction;
  return differenceOf(pair, on_a, supportPoint(pair.b, in_b, pair.vertex_of_b));
}

}  // namespace collision_monitor
