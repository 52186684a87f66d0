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

/// What of a core is farthest in a direction.
struct ExtremeFeature {
  std::uint32_t vertex;  ///< of a hull
  double reach;          ///< [m] along the direction, from the core's origin
  bool may_be_level;     ///< false: nothing but a vertex for certain
};

inline ExtremeFeature extremeOfBox(const Eigen::Vector3d& half_extents,
                                   const Eigen::Vector3d& direction) noexcept {
  const Eigen::Vector3d size = direction.cwiseAbs();
  return {0, half_extents.dot(size), size.minCoeff() <= kLevelSine};
}

/// The same of a core that is no hull.
ExtremeFeature extremeOfPrimitive(const ConvexCore& core,
                                  const Eigen::Vector3d& direction) noexcept;

/// Of a hull's bounding radius: neighbours that seem to be no more than this farther than a vertex
/// are as far but for rounding. The two ends of an edge are, and the climb from one to the other
/// would cost as much as the proof.
constexpr double kReachRounding = 4e-16;

/// What `found`, a look at a vertex of a hull and its fans along `direction`, says of the hull; a
/// climb goes on where a neighbour is farther. The reach is that of the farthest that was seen.
[[gnu::always_inline]] inline ExtremeFeature extremeFrom(
    ConvexHull::Extreme found, const ConvexHull& hull, const Eigen::Vector3d& direction) noexcept {
  const double radius = hull.boundingRadius();
  if (found.beside > found.reach + kReachRounding * radius || !hull.canClimb()) {
    found = hull.extreme(direction, found.vertex);
  }
  return {found.vertex, std::max(found.reach, found.beside),
          found.beside >= found.reach - 2.0 * kLevelSine * radius};
}

/// `direction` is unit and in the frame of the core, `vertex` where a hull's climb starts.
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

/// Two cores seen from A's origin, along the world's axes.
struct PlacedPair {
  const PlacedCore& a;
  const PlacedCore& b;
  Eigen::Vector3d between;  ///< from A's origin to B's
  double size;              ///< [m] bounds every coordinate of the difference B - A
};

/// Corners of both cores, and the way from one to the other.
struct PlacedCorners {
  Eigen::Vector3d on_a;        ///< from A's origin, along the world's axes
  Eigen::Vector3d difference;  ///< from there to B's
};

inline PlacedPair makePlacedPair(const PlacedCore& a, const PlacedCore& b) noexcept {
  const Eigen::Vector3d between = b.world_from_core.translation - a.world_from_core.translation;
  return {a, b, between, reachOf(a.core) + reachOf(b.core) + between.lpNorm<1>()};
}

/// A direction of the world as a core sees it.
inline Eigen::Vector3d directionIn(const PlacedCore& core,
                                   const Eigen::Vector3d& direction) noexcept {
  const double* x = core.world_from_core.rotation.data();
  const double* y = x + 3;
  const double* z = y + 3;
  // In plain numbers, as in along().
  return {x[0] * direction.x() + x[1] * direction.y() + x[2] * direction.z(),
          y[0] * direction.x() + y[1] * direction.y() + y[2] * direction.z(),
          z[0] * direction.x() + z[1] * direction.y() + z[2] * direction.z()};
}

/// The planes across a direction that hold A and B between them. What touches them of hulls are
/// then the vertices of the pair.
struct SupportPlanes {
  Eigen::Vector3d normal;  ///< unit, from A to B
  double gap;              ///< [m] from A's plane to B's; negative where they overlap
  bool may_be_level;       ///< false: areLevel() for certain does not hold
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

/// Whether what touches the planes shares more than a point: a face and an edge or face, or two
/// parallel edges.
/// @pre planes.may_be_level.
bool areLevel(const PlacedPair& pair, const SupportPlanes& planes) noexcept;

/// Whether the planes prove a distance or, if it is negative, a depth: that their gap is this, up
/// to `tolerance`.
inline bool meet(const SupportPlanes& planes, double distance, double tolerance) noexcept {
  return std::abs(distance - planes.gap) <= tolerance;
}

/// The same where no other points would do as well.
inline bool isProven(const PlacedPair& pair, const SupportPlanes& planes, double distance,
                     double tolerance) noexcept {
  return meet(planes, distance, tolerance) && !(planes.may_be_level && areLevel(pair, planes));
}

/// rotation * v, each number summed in the same order, as lanes do; Eigen sums the third in
/// another.
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

/// The corner that touches the plane across a direction, which is in the core's frame.
/// @pre of a hull: its vertex is the farthest there.
Eigen::Vector3d cornerOf(const PlacedCore& placed, const Eigen::Vector3d& direction) noexcept;

/// The corners that touch the planes.
ConvexWarmStart::Ends cornersOf(const PlacedPair& pair, const SupportPlanes& planes) noexcept;

}  // namespace collision_monitor
