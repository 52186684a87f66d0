// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <limits>

#include "narrow_phase/closed_form/closest_points.h"
#include "narrow_phase/closed_form/core_distance.h"
#include "narrow_phase/distance.h"
#include "narrow_phase/sat/axis_contact.h"

// The distance of two convex bodies is their largest separation over all directions. It is along
// one of the fifteen axes unless a corner is nearest. So if the best axis has two points that
// realise it, it gives the distance. If not, a corner of one box is nearest to the other box, and
// sixteen corners are tried. Overlapping boxes always realise the best axis.
namespace collision_monitor {
namespace {

struct NearestCorner {
  double distance_squared{std::numeric_limits<double>::infinity()};
  Eigen::Vector3d signs{Eigen::Vector3d::Ones()};  // of the corner of B
};

Eigen::Vector3d cornerOfB(const BoxPair& pair, const Eigen::Vector3d& signs) noexcept {
  return pair.center_of_b + pair.a_from_b * signs.cwiseProduct(pair.half_b);
}

NearestCorner nearestCornerOfB(const BoxPair& pair) noexcept {
  NearestCorner nearest;
  const Eigen::Vector3d x = pair.half_b.x() * pair.a_from_b.col(0);
  const Eigen::Vector3d y = pair.half_b.y() * pair.a_from_b.col(1);
  const Eigen::Vector3d z = pair.half_b.z() * pair.a_from_b.col(2);
  for (const double sx : {-1.0, 1.0}) {
    for (const double sy : {-1.0, 1.0}) {
      for (const double sz : {-1.0, 1.0}) {
        const Eigen::Vector3d corner = pair.center_of_b + sx * x + sy * y + sz * z;
        const Eigen::Vector3d beyond = (corner.cwiseAbs() - pair.half_a).cwiseMax(0.0);
        const double distance_squared = beyond.squaredNorm();
        if (distance_squared < nearest.distance_squared) {
          nearest.distance_squared = distance_squared;
          nearest.signs = {sx, sy, sz};
        }
      }
    }
  }
  return nearest;
}

// Moves the points of parallel edges to the middle of their common part, so that they do not jump
// from end to end.
void centerOnParallelEdges(const BoxPair& pair, const Eigen::Vector3d& signs,
                           SignedDistance& cores) noexcept {
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (Eigen::Index j = 0; j < 3; ++j) {
      const double aligned = pair.a_from_b(i, j);
      const double across = (pair.a_from_b.col(j) - aligned * Eigen::Vector3d::Unit(i)).norm();
      if (across > kParallel || std::abs(cores.normal_a_to_b[i]) > kParallel) {
        continue;
      }
      const double middle = cores.point_on_b[i] - signs[j] * aligned * pair.half_b[j];
      const double low = std::max(-pair.half_a[i], middle - pair.half_b[j]);
      const double high = std::min(pair.half_a[i], middle + pair.half_b[j]);
      cores.point_on_a[i] = 0.5 * (low + high);
      cores.point_on_b[i] = cores.point_on_a[i];
    }
  }
}

SignedDistance cornerOfBToBox(const BoxPair& pair, const NearestCorner& nearest) noexcept {
  SignedDistance cores;
  cores.point_on_b = cornerOfB(pair, nearest.signs);
  cores.point_on_a = closestInBox(pair.half_a, cores.point_on_b);
  const Eigen::Vector3d between = cores.point_on_b - cores.point_on_a;
  cores.distance = between.norm();
  cores.normal_a_to_b = between / cores.distance;
  centerOnParallelEdges(pair, nearest.signs, cores);
  return cores;
}

SignedDistance boxToBox(const BoxPair& pair) noexcept {
  const Separations separations = separationsOfBoxes(pair);
  if (separations.largest <= kTouching) {
    return nearestContact(pair, separations);
  }
  SignedDistance cores;
  if (contactAlongAxis(pair, separations, cores)) {
    return cores;
  }
  const NearestCorner of_b = nearestCornerOfB(pair);
  const BoxPair from_b = swapped(pair);
  const NearestCorner of_a = nearestCornerOfB(from_b);
  if (of_b.distance_squared <= of_a.distance_squared) {
    return cornerOfBToBox(pair, of_b);
  }
  return swapped(placed(aFromB(pair), cornerOfBToBox(from_b, of_a)));
}

}  // namespace

SignedDistance distanceBetween(const RoundedBox& a, const Pose& world_from_a, const RoundedBox& b,
                               const Pose& world_from_b) noexcept {
  const BoxPair pair = makeBoxPair(a.half_extents, world_from_a, b.half_extents, world_from_b);
  return inflated(placed(world_from_a, boxToBox(pair)), a.radius, b.radius);
}

}  // namespace collision_monitor
