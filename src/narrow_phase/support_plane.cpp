// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/support_plane.h"

#include <cmath>

#include "narrow_phase/extreme_feature.h"

namespace collision_monitor {

bool isProven(const PlacedPair& pair, const Eigen::Vector3d& normal, double distance,
              double tolerance) noexcept {
  const Eigen::Matrix3d& turn_a = pair.a.world_from_core.rotation;
  const Eigen::Matrix3d& turn_b = pair.b.world_from_core.rotation;
  const ExtremeFeature of_a = extremeOf(pair.a.core, turn_a.transpose() * normal, pair.a.vertex);
  const ExtremeFeature of_b = extremeOf(pair.b.core, -(turn_b.transpose() * normal), pair.b.vertex);
  pair.a.vertex = of_a.vertex;
  pair.b.vertex = of_b.vertex;
  const double gap = normal.dot(pair.between) - of_a.reach - of_b.reach;
  return std::abs(distance - gap) <= tolerance && !areLevel(of_a, turn_a, of_b, turn_b);
}

ConvexWarmStart::Ends supportEnds(const PlacedPair& pair, const Eigen::Vector3d& normal) noexcept {
  const Eigen::Vector3d in_a = pair.a.world_from_core.rotation.transpose() * normal;
  const Eigen::Vector3d in_b = pair.b.world_from_core.rotation.transpose() * -normal;
  return {supportPoint(pair.a.core, in_a, pair.a.vertex),
          supportPoint(pair.b.core, in_b, pair.b.vertex)};
}

}  // namespace collision_monitor
