// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "collision_monitor/narrow_phase/convex_distance.h"
#include "geometry/bvh/visit_held.h"
#include "narrow_phase/gjk/convex_core.h"

/// Polytopes that are apart, many pairs at once, each nearest at the corners of its last search:
/// the first step of distanceFromWarmStart in columns. Every row does what the plain step does, in
/// the same order.
namespace collision_monitor {

constexpr std::size_t kProofRows = 32;

/// What a row reads of one of its two cores, a hull or a box; of a cylinder only its pose.
struct ProofSide {
  const double* world_from_core;       ///< rotation, column by column, and translation
  const ConvexHull* hull;              ///< null: a box
  std::array<double, 3> half_extents;  ///< of a box
  double radius;                       ///< [m] inflates the core
  std::uint32_t vertex;                ///< of a hull: start of the climb; receives its end
};

/// Fills the side of a geometry, and the bounding radius of its core.
/// @return false for geometries without corners, or without fans to look at.
inline bool fillSide(const ConvexGeometry& geometry, const Pose& world_from_core,
                     std::uint32_t vertex, ProofSide& side, double& reach) noexcept {
  side.world_from_core = world_from_core.rotation.data();
  side.vertex = vertex;
  if (const auto* hull = std::get_if<ConvexHull>(&geometry)) {
    side.hull = hull;
    side.radius = 0.0;
    reach = hull->boundingRadius();
    return hull->canClimb();
  }
  const auto fill = [&](const auto& held) noexcept {
    if constexpr (std::is_same_v<decltype(held), const HalfSpace&>) {
      return false;
    } else {
      const auto [core, radius] = inflatedCoreOf(held);
      const Eigen::Vector3d& half = core.half_extents;
      side.hull = nullptr;
      side.half_extents = {half.x(), half.y(), half.z()};
      side.radius = radius;
      reach = reachOf(core);
      return !isSmooth(core);
    }
  };
  return visitHeld(fill, geometry);
}

/// Columns of ProofRows, for the cores. Frames: world unless said otherwise.
namespace proof {
enum Column : std::size_t {
  distance,                             ///< [m] NaN: not proven
  point_on_a,                           ///< x, y, z
  normal = point_on_a + 3,              ///< unit, from A to B
  size = normal + 3,                    ///< as PlacedPair::size; before: the bounding radii
  direction_in_a,                       ///< the normal in A's frame
  direction_in_b = direction_in_a + 3,  ///< minus the normal, in B's frame
  between = direction_in_b + 3,         ///< [m] from A's origin to B's, along the normal
  reach_of_a,                           ///< [m] from A's origin towards B
  reach_of_b,                           ///< [m] from B's towards A
  count
};
}  // namespace proof

/// Pairs with the same number of corners. 1: a corner is nearest, 2: an edge, 3: a face.
struct ProofRows {
  std::size_t count;  ///< at most kProofRows
  std::array<ProofSide, kProofRows> a;
  std::array<ProofSide, kProofRows> b;
  std::array<const double*, kProofRows> ends;  ///< ConvexWarmStart::ends
  std::array<std::size_t, kProofRows> query;   ///< of the caller
  std::array<bool, kProofRows> may_be_level;   ///< as SupportPlanes
  alignas(64) std::array<std::array<double, kProofRows>, proof::count> at;
};

/// Fills the columns, and `vertex` of both sides. Rows that are not proven are left to
/// distanceFromWarmStart: poses that are not finite, cores that touch or overlap, and pairs that
/// need fewer corners or have nearer ones.
/// @param corners of each pair, 1 to 3. @pre there is a row.
void proveRows(std::size_t corners, ProofRows& rows) noexcept;

}  // namespace collision_monitor
