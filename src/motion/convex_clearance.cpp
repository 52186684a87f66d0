// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "motion/convex_clearance.h"

#include <algorithm>
#include <type_traits>

#include "geometry/bvh/visit_held.h"
#include "geometry/constants.h"
#include "narrow_phase/gjk/convex_core.h"

namespace collision_monitor {
namespace {

/// [m] The greatest n . x of a geometry's points x in the world, for an n of any length. Infinite
/// for half spaces, unless n is their normal.
double endAlong(const Eigen::Vector3d& n, const PlacedConvex& placed) noexcept {
  const auto end_of = [&](const auto& held) noexcept {
    if constexpr (std::is_same_v<std::decay_t<decltype(held)>, HalfSpace>) {
      const Eigen::Vector3d normal = placed.world_from_body.rotation.col(2);
      const double along = n.dot(normal);
      constexpr double kRounding = 1e-12;
      return (n - along * normal).norm() <= kRounding * along
                 ? along * normal.dot(placed.world_from_body.translation)
                 : kInfinity;
    } else {
      const InflatedCore inflated = inflatedCoreOf(held);
      const Pose& world_from_core = placed.world_from_body;
      std::uint32_t vertex = 0;
      const Eigen::Vector3d farthest =
          supportPoint(inflated.core, world_from_core.rotation.transpose() * n, vertex);
      return n.dot(world_from_core * farthest) + inflated.radius * n.norm();
    }
  };
  return visitHeld(end_of, placed.geometry);
}

}  // namespace

double clearanceOf(const PlacedConvex& a, const PlacedConvex& b, const RelativeMotion& motion,
                   ConvexSearch& search) noexcept {
  const ConvexDistance found =
      signedDistanceBetween(a.geometry, a.world_from_body, b.geometry, b.world_from_body, search);
  if (found.quality == Quality::unknown || !(found.measured.distance > motion.deviation)) {
    return -kInfinity;
  }
  const Eigen::Vector3d& n = found.measured.normal_a_to_b;
  // A point x of B has n . x + s * (rate + gradient . x) along the normal, at a time s.
  const Eigen::Vector3d gradient = n.cross(motion.turn);
  const double rate = n.dot(motion.velocity) - gradient.dot(motion.center);
  const double start =
      std::min(-endAlong(-(n + gradient), b) + rate, -endAlong(-(n - gradient), b) - rate);
  return start - endAlong(n, a) - motion.deviation;
}

}  // namespace collision_monitor
