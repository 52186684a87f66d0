// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/convex/search_round.h"

#include <algorithm>
#include <cmath>

#include "narrow_phase/closed_form/core_distance.h"
#include "narrow_phase/gjk/flat_contact.h"
#include "narrow_phase/warm_start/distance_from_warm_start.h"

namespace collision_monitor {
namespace {

// Moves a point near a rim onto it. The points of GJK lie on chords of rims.
Eigen::Vector3d nearRim(const Eigen::Vector3d& point,
                        const Eigen::Vector3d& half_extents) noexcept {
  constexpr double kNearly = 0.9;
  const double radius = point.head<2>().norm();
  const bool is_near =
      std::abs(point.z()) >= kNearly * half_extents.z() && radius >= kNearly * half_extents.x();
  if (!is_near) {
    return point;
  }
  const double stretch = half_extents.x() / radius;
  return {stretch * point.x(), stretch * point.y(), std::copysign(half_extents.z(), point.z())};
}

// The axis of a box or cylinder that is nearest to a direction, in its half space; else zero.
Eigen::Vector3d axisNear(const Eigen::Vector3d& direction, const ConvexCore& core,
                         const Eigen::Matrix3d& axes) noexcept {
  if (core.kind != ConvexCore::Kind::box && core.kind != ConvexCore::Kind::cylinder) {
    return Eigen::Vector3d::Zero();
  }
  Eigen::Index i = 2;
  const Eigen::Vector3d along = axes.transpose() * direction;
  if (core.kind == ConvexCore::Kind::box) {
    along.cwiseAbs().maxCoeff(&i);
  }
  return std::copysign(1.0, along[i]) * axes.col(i);
}

// Measures cores that are level across `normal` and face each other.
bool finishAcross(const Eigen::Vector3d& normal, const PlacedPair& pair,
                  SignedDistance& measured) noexcept {
  const SupportPlanes planes = supportPlanes(pair, normal);
  if (!planes.may_be_level || planes.gap <= touchingDistance(pair.size)) {
    return false;
  }
  const Eigen::Vector3d on_a =
      pair.a.world_from_core * cornerOf(pair.a, directionIn(pair.a, normal));
  measured = {planes.gap, on_a, on_a + planes.gap * normal, normal};
  return centerOnPatch(pair, planes, measured);
}

// Measures cores that are level across an axis of one of them, if it is near to a direction.
bool finishLevel(ConvexPair& pair, const Eigen::Vector3d& direction,
                 SignedDistance& measured) noexcept {
  constexpr double kNear = 0.9;
  const Pose origin;
  const PlacedCore a{pair.a, origin, pair.vertex_of_a};
  const PlacedCore b{pair.b, pair.a_from_b, pair.vertex_of_b};
  const PlacedPair placed = makePlacedPair(a, b);
  for (const PlacedCore& core : {a, b}) {
    const Eigen::Vector3d axis = axisNear(direction, core.core, core.world_from_core.rotation);
    if (axis.dot(direction) > kNear && finishAcross(axis, placed, measured)) {
      return true;
    }
  }
  return false;
}

// Keeps the closest points so far. Of two cylinders at least one is mostly on a rim.
void keepClosest(const GjkResult& paused, const ConvexPair& pair, ConvexWarmStart& warm) noexcept {
  keepWarm(paused.simplex.vertices.data(), paused.simplex.size, pair, warm);
  if (isSmooth(pair.a) && isSmooth(pair.b)) {
    warm.size = 1;
    warm.ends[0] = {nearRim(paused.simplex.pointOnA(), pair.a.half_extents),
                    nearRim(paused.simplex.pointOnB(), pair.b.half_extents)};
  }
}

// Along nearly parallel rims the closest points are hard to tell, and GJK finds better ones.
bool areNearlyParallel(const ConvexPair& pair) noexcept {
  constexpr double kSine = 1e-2;
  return isSmooth(pair.a) && isSmooth(pair.b) &&
         pair.a_from_b.rotation.col(2).head<2>().norm() < kSine;
}

// Follows the corners, edges and rims that are kept.
bool finishRound(ConvexPair& pair, ConvexWarmStart& warm, SignedDistance& measured) noexcept {
  const Pose origin;
  const auto closest = distanceFromWarmStart({pair.a, origin, pair.vertex_of_a},
                                             {pair.b, pair.a_from_b, pair.vertex_of_b}, warm);
  if (closest) {
    measured = closest->cores;
  }
  return closest.has_value();
}

}  // namespace

bool searchRound(ConvexPair& pair, ConvexSearch& search, GjkResult& found,
                 SignedDistance& measured) noexcept {
  constexpr int kFirst = 4;
  GjkLimits limits{search.cutoff, 0.0, kFirst};
  found = runGjk(pair, search.warm, limits);
  while (found.state == GjkResult::State::paused) {
    if (found.lower > touchingDistance(pair)) {
      keepClosest(found, pair, search.warm);
      if (finishLevel(pair, found.simplex.normal, measured) ||
          (!areNearlyParallel(pair) && finishRound(pair, search.warm, measured))) {
        return true;
      }
    }
    limits.steps *= 2;
    resumeGjk(pair, limits, found);
  }
  return false;
}

}  // namespace collision_monitor
