// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/narrow_phase/mesh_distance.h"

#include <algorithm>
#include <cmath>

#include "narrow_phase/core_distance.h"
#include "narrow_phase/mesh_search.h"
#include "narrow_phase/triangle_edges.h"

namespace collision_monitor {
namespace {

void measureTriangles(const MeshPair& pair, const TrianglePair& triangles,
                      NearestSearch& search) noexcept {
  offer(triangles, search, [&](const PointPair& best) {
    return nearestPoints(pair.a.triangles()[triangles.a], triangleOfB(pair, triangles.b), best);
  });
}

void searchFrom(const MeshPair& pair, std::uint32_t visit_budget, MeshQueryMemory& memory,
                NearestSearch& search) noexcept {
  searchNearest(pair.rounding, visit_budget, memory, search,
                [&](const MeshQueryMemory::Waiting& next, float limit, WaitingPairs& waiting) {
                  const std::uint32_t child_a = childOf(pair.a, next.a);
                  const std::uint32_t child_b = childOf(pair.b, next.b);
                  if (isTriangle(child_a) && isTriangle(child_b)) {
                    measureTriangles(pair, {triangleAt(child_a), triangleAt(child_b)}, search);
                  } else {
                    openLarger(pair, next, limit, waiting);
                  }
                });
}

// Unit normal from A to B of two points that may be one.
Eigen::Vector3d normalBetween(const MeshPair& pair, const NearestSearch& search, double distance) {
  if (distance > kTouching) {
    return (search.best.on_b - search.best.on_a) / distance;
  }
  return anyNormalOf(prepare(pair.a.triangles()[search.nearest.a]));
}

void report(const MeshPair& pair, const NearestSearch& search, const Pose& world_from_a,
            MeshDistance& answer) noexcept {
  const double distance = std::sqrt(search.best.squared_distance);
  answer.state = distance > pair.rounding ? MeshState::exact : MeshState::overlapping;
  answer.nearest = search.nearest;
  answer.measured = placed(world_from_a, {distance, search.best.on_a, search.best.on_b,
                                          normalBetween(pair, search, distance)});
}

bool isPairOf(const MeshPair& pair, const TrianglePair& triangles) noexcept {
  return triangles.a < pair.a.triangles().size() && triangles.b < pair.b.triangles().size();
}

// What is known when the search ended early: nothing that was left is nearer than its bound.
void reportBound(const NearestSearch& search, double stop_beyond, MeshDistance& answer) noexcept {
  const double squared = std::min(search.best.squared_distance, search.squared_open);
  answer.nearest = search.nearest;
  if (squared <= std::numeric_limits<double>::max()) {
    answer.state = MeshState::lower_bound;
    answer.measured.distance = std::min(std::sqrt(squared), stop_beyond);
  }
}

// Surfaces that do not meet may still be one inside the other.
void reportContainment(const MeshPair& pair, const Pose& world_from_a, MeshQueryMemory& memory,
                       MeshDistance& answer) noexcept {
  if (const std::optional<Eigen::Vector3d> shared = pointHeld(pair, memory)) {
    answer.state = MeshState::overlapping;
    answer.measured.distance = 0.0;
    answer.measured.point_on_a = world_from_a * *shared;
    answer.measured.point_on_b = answer.measured.point_on_a;
  }
}

}  // namespace

MeshDistance distanceBetween(const PlacedMesh& a, const PlacedMesh& b, MeshQueryMemory& memory,
                             const TrianglePair& start, const MeshQueryLimits& limits) noexcept {
  MeshDistance answer;
  if (!isFinite(a.world_from_mesh) || !isFinite(b.world_from_mesh)) {
    return answer;
  }
  const MeshPair pair = makeMeshPair(a, b);
  NearestSearch search;
  search.best.squared_distance = limits.stop_beyond * limits.stop_beyond;
  if (isPairOf(pair, start)) {
    measureTriangles(pair, start, search);
  }
  searchFrom(pair, limits.visit_budget, memory, search);
  answer.visits = search.visits;
  if (isPairOf(pair, search.nearest) && search.isComplete()) {
    report(pair, search, a.world_from_mesh, answer);
  } else {
    reportBound(search, limits.stop_beyond, answer);
  }
  if (answer.state != MeshState::overlapping) {
    reportContainment(pair, a.world_from_mesh, memory, answer);
  }
  return answer;
}

}  // namespace collision_monitor
