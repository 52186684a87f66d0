// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/warm_start/follow_feature.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "narrow_phase/gjk/simplex.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

// A point of the other core in the cylinder's frame.
Vector3d seen(const Vector3d& point, const PlacedPair& pair) noexcept {
  return directionIn(pair.a, turned(pair.b.world_from_core.rotation, point) + pair.between);
}

}  // namespace

ClosestOnCylinder closestToCorner(const PlacedPair& pair, const Vector3d& corner) noexcept {
  return closestOf(seen(corner, pair), pair.a.core.half_extents);
}

ClosestOnCylinder closestToEdge(const PlacedPair& pair, const EdgeStart& start,
                                double& share) noexcept {
  const Vector3d from = seen(start.first, pair);
  const Vector3d delta = start.second - start.first;
  const Vector3d edge = directionIn(pair.a, turned(pair.b.world_from_core.rotation, delta));
  const double last = along(edge, start.last_closest - from) / along(edge, edge);
  share = std::max(0.0, std::min(1.0, last));
  return closestToEdge(from, edge, pair.a.core.half_extents, share);
}

ClosestOnCylinder closestToRim(const PlacedPair& pair, Vector3d& on_other) noexcept {
  const Eigen::Matrix3d& rotation = pair.b.world_from_core.rotation;
  const double radius = pair.b.core.half_extents.x();
  const double height = std::copysign(pair.b.core.half_extents.z(), on_other.z());
  Rim rim;
  rim.center = directionIn(pair.a, pair.between + height * rotation.col(2));
  rim.across.col(0) = radius * directionIn(pair.a, rotation.col(0));
  rim.across.col(1) = radius * directionIn(pair.a, rotation.col(1));
  const double per_length =
      1.0 / std::sqrt(on_other.x() * on_other.x() + on_other.y() * on_other.y());
  Eigen::Vector2d turn(per_length * on_other.x(), per_length * on_other.y());
  ClosestOnCylinder closest = closestToRim(rim, pair.a.core.half_extents, turn);
  on_other = {radius * turn.x(), radius * turn.y(), height};
  return closest;
}

ClosestOnCylinder closestToAxis(const PlacedPair& pair, double& share) noexcept {
  const Vector3d half_axis = pair.b.core.half_extents.z() * pair.b.world_from_core.rotation.col(2);
  const Vector3d from = directionIn(pair.a, pair.between - half_axis);
  const Vector3d edge = 2.0 * directionIn(pair.a, half_axis);
  return closestToEdge(from, edge, pair.a.core.half_extents, share);
}

bool closestToFace(const PlacedPair& pair, const std::array<Vector3d, 3>& corners,
                   ClosestOnCylinder& closest) noexcept {
  std::array<Vector3d, 4> points;
  for (std::size_t i = 0; i < 3; ++i) {
    points[i] = seen(corners[i], pair);
  }
  Vector3d normal = (points[1] - points[0]).cross(points[2] - points[0]).normalized();
  normal = normal.dot(points[0]) < 0.0 ? Vector3d(-normal) : normal;
  std::uint32_t none = 0;
  closest.on_cylinder = supportPoint(pair.a.core, normal, none);
  for (std::size_t i = 0; i < 3; ++i) {
    points[i] -= closest.on_cylinder;
  }
  closest.away = normal.dot(points[0]) * normal;
  NearestOnSimplex nearest;
  return nearestOfSimplex(points, 3, nearest);
}

ClosestProof proveClosest(const PlacedPair& pair, const ClosestOnCylinder& closest,
                          double radius) noexcept {
  const double length = std::sqrt(along(closest.away, closest.away));
  ClosestProof proof;
  proof.distance = length - radius;
  proof.is_apart = proof.distance > touchingDistance(pair.size);
  proof.is_proven = false;
  if (!proof.is_apart) {
    return proof;
  }
  const Vector3d in_cylinder = (1.0 / length) * closest.away;
  proof.normal = turned(pair.a.world_from_core.rotation, in_cylinder);
  const ExtremeFeature of_a = extremeOfPrimitive(pair.a.core, in_cylinder);
  const ExtremeFeature of_b =
      extremeOf(pair.b.core, -directionIn(pair.b, proof.normal), pair.b.vertex);
  pair.b.vertex = of_b.vertex;
  const SupportPlanes planes{proof.normal,
                             along(proof.normal, pair.between) - of_a.reach - of_b.reach,
                             of_a.may_be_level && of_b.may_be_level};
  proof.is_proven = isProven(pair, planes, proof.distance, smoothTolerance(pair.size));
  return proof;
}

}  // namespace collision_monitor
