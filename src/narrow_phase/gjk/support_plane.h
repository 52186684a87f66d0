// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "narrow_phase/gjk/convex_pair.h"

namespace collision_monitor {

/// Features count as level, and edges as parallel, up to this sine.
constexpr double kLevelSine = 1e-11;

/// The part of a core that is farthest in a direction.
struct ExtremeFeature {
  std::uint32_t vertex;  ///< of a hull
  double reach;          ///< [m] along the direction, from the core's origin
  bool may_be_level;     ///< false: certainly only a vertex
};

inline ExtremeFeature extremeOfBox(const Eigen::Vector3d& half_extents,
                                   const Eigen::Vector3d& direction) noexcept {
  const Eigen::Vector3d size = direction.cwiseAbs();
  return {0, half_extents.dot(size), size.minCoeff() <= kLevelSine};
}

/// The same for a core that is not a hull.
ExtremeFeature extremeOfPrimitive(const ConvexCore& core,
                                  const Eigen::Vector3d& direction) noexcept;

/// Share of a hull's bounding radius. Neighbors that seem farther than a vertex by at most this are
/// equally far but for rounding, as the two ends of an edge are. A climb from one to the other
/// would cost as much as the proof.
constexpr double kReachRounding = 4e-16;

/// Completes `found`, a look at a vertex of a hull and its fans along `direction`. Climbs on if a
/// neighbor is farther. The reach is that of the farthest vertex seen.
[[gnu::always_inline]] inline ExtremeFeature extremeFrom(
    ConvexHull::Extreme found, const ConvexHull& hull, const Eigen::Vector3d& direction) noexcept {
  const double radius = hull.boundingRadius();
  if (found.beside > found.reach + kReachRounding * radius || !hull.canClimb()) {
    found = hull.extreme(direction, found.vertex);
  }
  return {found.vertex, std::max(found.reach, found.beside),
          found.beside >= found.reach - 2.0 * kLevelSine * radius};
}

/// `direction` is unit, in the core's frame. The climb of a hull starts at `vertex`.
/// Error: see ConvexHull::supportVertex.
inline ExtremeFeature extremeOf(const ConvexCore& core, const Eigen::Vector3d& direction,
                                std::uint32_t vertex) noexcept {
  if (core.kind != ConvexCore::Kind::hull) {
    return extremeOfPrimitive(core, direction);
  }
  const ConvexHull& hull = *core.hull;
  return extremeFrom(
      {vertex, along(direction, hull.vertices()[vertex]), hull.reachBeside(direction, vertex)},
      hull, direction);
}

struct PlacedCore {
  const ConvexCore& core;
  const Pose& world_from_core;
  std::uint32_t& vertex;  ///< where the last climb of a hull ended
};

/// Two cores seen from A's origin, in world axes.
struct PlacedPair {
  const PlacedCore& a;
  const PlacedCore& b;
  Eigen::Vector3d between;  ///< from A's origin to B's
  double size;              ///< [m] bounds every coordinate of the difference B - A
};

/// A corner of each core, and the vector between them.
struct PlacedCorners {
  Eigen::Vector3d on_a;        ///< from A's origin, in world axes
  Eigen::Vector3d difference;  ///< from on_a to B's corner
};

inline PlacedPair makePlacedPair(const PlacedCore& a, const PlacedCore& b) noexcept {
  const Eigen::Vector3d between = b.world_from_core.translation - a.world_from_core.translation;
  return {a, b, between, reachOf(a.core) + reachOf(b.core) + between.lpNorm<1>()};
}

/// Turns a world direction into the core's frame.
inline Eigen::Vector3d directionIn(const PlacedCore& core,
                                   const Eigen::Vector3d& direction) noexcept {
  const double* x = core.world_from_core.rotation.data();
  const double* y = x + 3;
  const double* z = y + 3;
  // Plain numbers, as in along().
  return {x[0] * direction.x() + x[1] * direction.y() + x[2] * direction.z(),
          y[0] * direction.x() + y[1] * direction.y() + y[2] * direction.z(),
          z[0] * direction.x() + z[1] * direction.y() + z[2] * direction.z()};
}

/// The support planes of A and B across a direction, facing each other. The vertices of the pair
/// are those where hulls touch them.
struct SupportPlanes {
  Eigen::Vector3d normal;  ///< unit, from A to B
  double gap;              ///< [m] from A's plane to B's; negative if they overlap
  bool may_be_level;       ///< false: areLevel() certainly does not hold
};

/// @param normal unit, from A to B.
inline SupportPlanes supportPlanes(const PlacedPair& pair, const Eigen::Vector3d& normal) noexcept {
  const ExtremeFeature of_a = extremeOf(pair.a.core, directionIn(pair.a, normal), pair.a.vertex);
  const ExtremeFeature of_b = extremeOf(pair.b.core, -directionIn(pair.b, normal), pair.b.vertex);
  pair.a.vertex = of_a.vertex;
  pair.b.vertex = of_b.vertex;
  return {normal, along(normal, pair.between) - of_a.reach - of_b.reach,
          of_a.may_be_level && of_b.may_be_level};
}

/// True if the features that touch the planes share more than a point: a face and an edge or face,
/// or two parallel edges.
/// @pre planes.may_be_level.
bool areLevel(const PlacedPair& pair, const SupportPlanes& planes) noexcept;

/// True if the planes prove `distance` (a depth if negative): their gap differs from it by at most
/// `tolerance`.
inline bool meet(const SupportPlanes& planes, double distance, double tolerance) noexcept {
  return std::abs(distance - planes.gap) <= tolerance;
}

/// The same, and no other points would do as well.
inline bool isProven(const PlacedPair& pair, const SupportPlanes& planes, double distance,
                     double tolerance) noexcept {
  return meet(planes, distance, tolerance) && !(planes.may_be_level && areLevel(pair, planes));
}

/// rotation * v. Sums each number in the order of the lanes; Eigen sums the third in another.
inline Eigen::Vector3d turned(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& v) noexcept {
  return v.x() * rotation.col(0) + v.y() * rotation.col(1) + v.z() * rotation.col(2);
}

inline PlacedCorners place(const ConvexWarmStart::Ends& ends, const PlacedPair& pair) noexcept {
  PlacedCorners placed;
  placed.on_a = turned(pair.a.world_from_core.rotation, ends.on_a);
  placed.difference = turned(pair.b.world_from_core.rotation, ends.on_b);
  placed.difference += pair.between - placed.on_a;
  return placed;
}

/// The corner that touches the plane across `direction`, which is in the core's frame.
/// @pre the vertex of a hull is the farthest in that direction.
Eigen::Vector3d cornerOf(const PlacedCore& placed, const Eigen::Vector3d& direction) noexcept;

/// The corners that touch the planes.
ConvexWarmStart::Ends cornersOf(const PlacedPair& pair, const SupportPlanes& planes) noexcept;

}  // namespace collision_monitor
