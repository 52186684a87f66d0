// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/confirm_nearest.h"

#include <array>

#include "narrow_phase/confirm_cylinder.h"
#include "narrow_phase/extreme_feature.h"
#include "narrow_phase/gjk.h"
#include "narrow_phase/simplex.h"

namespace collision_monitor {

bool confirmNearest(const PlacedCore& a, const PlacedCore& b, ConvexWarmStart& warm,
                    SignedDistance& cores) noexcept {
  if (warm.size == 0 || warm.size > 3) {
    return false;
  }
  if (isSmooth(a.core) || isSmooth(b.core)) {
    return confirmCylinder(a, b, warm, cores);
  }
  // Along the world's axes, from A's origin.
  const Eigen::Matrix3d& turn_a = a.world_from_core.rotation;
  const Eigen::Matrix3d& turn_b = b.world_from_core.rotation;
  const Eigen::Vector3d between = b.world_from_core.translation - a.world_from_core.translation;
  std::array<Eigen::Vector3d, 3> on_a;
  std::array<Eigen::Vector3d, 4> differences;
  for (std::size_t i = 0; i < warm.size; ++i) {
    on_a[i].noalias() = turn_a * warm.ends[i].on_a;
    differences[i].noalias() = turn_b * warm.ends[i].on_b;
    differences[i] += between - on_a[i];
  }
  NearestPoint nearest;
  if (!nearestInside(differences, static_cast<int>(warm.size), nearest)) {
    return false;
  }
  const double size = reachOf(a.core) + reachOf(b.core) + between.norm();
  const double distance = std::sqrt(nearest.squared);
  const Eigen::Vector3d normal = normalOf(nearest);
  const ExtremeFeature of_a = extremeOf(a.core, turn_a.transpose() * normal, warm.vertex_of_a);
  const ExtremeFeature of_b = extremeOf(b.core, -(turn_b.transpose() * normal), warm.vertex_of_b);
  warm.vertex_of_a = of_a.vertex;
  warm.vertex_of_b = of_b.vertex;
  const double gap = normal.dot(between) - of_a.reach - of_b.reach;
  const bool is_settled = distance > touchingDistance(size) && distance - gap <= roundingOf(size);
  if (!is_settled || areLevel(of_a, turn_a, of_b, turn_b)) {
    return false;
  }
  cores.distance = distance;
  cores.normal_a_to_b = normal;
  cores.point_on_a = a.world_from_core.translation;
  for (std::size_t i = 0; i < warm.size; ++i) {
    cores.point_on_a += nearest.weights[i] * on_a[i];
  }
  cores.point_on_b = cores.point_on_a + distance * normal;
  return true;
}

}  // namespace collision_monitor
