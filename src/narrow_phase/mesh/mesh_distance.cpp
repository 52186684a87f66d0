// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/mesh/mesh_distance.h"

#include <algorithm>
#include <cmath>

#include "narrow_phase/closed_form/core_distance.h"
#include "narrow_phase/mesh/part_gap.h"
#include "narrow_phase/mesh_front/front_search.h"
#include "narrow_phase/triangle/triangle_edges.h"

namespace collision_monitor {
namespace {

void measureTriangles(const MeshPair& pair, const TrianglePair& triangles,
                      const MeshQueryMemory::NodePair& bounds, NearestSearch& search) noexcept {
  offer(
      triangles, bounds, search,
      [&](const PointPair& start, double squared_cutoff) {
        return boundedDistance(pair.a.triangles()[triangles.a], triangleOfB(pair, triangles.b),
                               start, squared_cutoff);
      },
      [&](const Eigen::Vector3d& direction) {
        return squaredGapAlong(direction, pair, triangles);
      });
}

void searchPairs(const MeshPair& pair, std::uint32_t visit_budget, NodePairQueue& pairs,
                 NearestSearch& search) noexcept {
  branchAndBound(
      pair.rounding, visit_budget, pairs, search,
      [&](const MeshQueryMemory::NodePair& next, float limit, NodePairQueue& queue) {
        const std::uint32_t child_a = childOf(pair.a, next.a);
        const std::uint32_t child_b = childOf(pair.b, next.b);
        if (isTriangle(child_a) && isTriangle(child_b)) {
          measureTriangles(pair, {triangleAt(child_a), triangleAt(child_b)}, next, search);
        } else {
          openLarger(pair, next, limit, queue);
        }
      });
}

// Unit normal from A to B of two points, which may coincide.
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
  const Eigen::Vector3d normal = normalBetween(pair, search, distance);
  SignedDistance measured{distance, search.best.on_a, search.best.on_b, normal};
  const double bound = std::sqrt(search.squaredBound());
  if (answer.state == MeshState::exact && bound < distance) {
    answer.shortfall = distance - bound;
    measured.distance = bound;
    measured.point_on_b = measured.point_on_a + bound * normal;
  }
  answer.measured = placed(world_from_a, measured);
}

bool isPairOf(const MeshPair& pair, const TrianglePair& triangles) noexcept {
  return triangles.a < pair.a.triangles().size() && triangles.b < pair.b.triangles().size();
}

// Reports what is known if the search ended early: nothing left out is nearer than its bound.
void reportBound(const NearestSearch& search, double stop_beyond, MeshDistance& answer) noexcept {
  const double squared = std::min(search.best.squared_distance, search.squared_open);
  answer.nearest = search.nearest;
  if (squared <= std::numeric_limits<double>::max()) {
    answer.state = MeshState::lower_bound;
    answer.measured.distance = std::min(std::sqrt(squared), stop_beyond);
  }
}

void reportHeld(const Holding& held, const Pose& world_from_a, MeshDistance& answer) noexcept {
  answer.state = MeshState::overlapping;
  answer.measured.distance = 0.0;
  answer.measured.point_on_a = world_from_a * *held.point;
  answer.measured.point_on_b = answer.measured.point_on_a;
  answer.held = held.probe;
}

// Surfaces that do not meet may still lie one inside the other.
void reportContainment(const MeshPair& pair, const Pose& world_from_a,
                       const MeshQueryLimits& limits, MeshQueryMemory& memory, KeptProbes probes,
                       MeshDistance& answer) noexcept {
  if (answer.state == MeshState::overlapping || (limits.at_least > 0.0 && !limits.asks_outside)) {
    return;
  }
  const double apart = answer.state == MeshState::unknown ? 0.0 : answer.measured.distance;
  const Holding held = pointHeld(pair, memory, {limits.asks_outside, apart, probes});
  answer.visits += held.visits;
  answer.outside = held.outside;
  if (held.point) {
    reportHeld(held, world_from_a, answer);
  }
}

// Asks for the probe that was held before. @return whether it still is
bool isStillHeld(const MeshPair& pair, const Pose& world_from_a, const MeshQueryLimits& limits,
                 MeshQueryMemory& memory, MeshDistance& answer) noexcept {
  const Holding held = probeHeld(pair, limits.held, memory);
  answer.visits = held.visits;
  if (held.point) {
    reportHeld(held, world_from_a, answer);
  }
  return held.point.has_value();
}

MeshDistance answerOf(const MeshPair& pair, const NearestSearch& search, const Pose& world_from_a,
                      double stop_beyond) noexcept {
  MeshDistance answer;
  answer.visits = search.visits;
  if (isPairOf(pair, search.nearest) && search.isComplete()) {
    report(pair, search, world_from_a, answer);
  } else {
    reportBound(search, stop_beyond, answer);
  }
  return answer;
}

NearestSearch searchWithin(const MeshQueryLimits& limits, double rounding) noexcept {
  NearestSearch search;
  search.best.squared_distance = limits.stop_beyond * limits.stop_beyond;
  search.tolerance = std::max(limits.tolerance, rounding);
  search.rounding = rounding;
  search.at_least = limits.at_least;
  return search;
}

// The query of two meshes for searchFromFront.
struct MeshQuery {
  const MeshPair& pair;

  bool areTriangles(Slot a, Slot b) const noexcept {
    return isTriangle(childOf(pair.a, a)) && isTriangle(childOf(pair.b, b));
  }
  TrianglePair trianglesAt(Slot a, Slot b) const noexcept {
    return {triangleAt(childOf(pair.a, a)), triangleAt(childOf(pair.b, b))};
  }
  void measure(const MeshQueryMemory::NodePair& bounds, NearestSearch& search) const noexcept {
    measureTriangles(pair, trianglesAt(bounds.a, bounds.b), bounds, search);
  }
  void choose(Slot a, Slot b, OpenedPair& opened) const noexcept {
    collision_monitor::choose(pair, a, b, opened);
  }
  Eigen::Matrix3d restingFromNode(const OpenedPair& opened) const noexcept {
    return opened.is_of_a ? Eigen::Matrix3d(Eigen::Matrix3d::Identity())
                          : Eigen::Matrix3d(-pair.a_from_b.rotation);
  }
  double squaredGapAlong(const Eigen::Vector3d& direction, Slot a, Slot b) const noexcept {
    return collision_monitor::squaredGapAlong(direction, pair, trianglesAt(a, b));
  }
  bool areParts(Slot a, Slot b) const noexcept { return collision_monitor::areParts(pair, a, b); }
  double gapOfParts(Slot a, Slot b, const Eigen::Vector3d& direction) const noexcept {
    return collision_monitor::gapOfParts(pair, a, b, direction);
  }
  PartGap searchGapOfParts(Slot a, Slot b, double goal) const noexcept {
    return collision_monitor::searchGapOfParts(pair, a, b, goal);
  }
};

}  // namespace

MeshDistance distanceBetween(const PlacedMesh& a, const PlacedMesh& b, MeshQueryMemory& memory,
                             const TrianglePair& start, const MeshQueryLimits& limits) noexcept {
  if (!isFinite(a.world_from_mesh) || !isFinite(b.world_from_mesh)) {
    return {};
  }
  const MeshPair pair = makeMeshPair(a, b);
  MeshDistance answer;
  if (isStillHeld(pair, a.world_from_mesh, limits, memory, answer)) {
    return answer;
  }
  NearestSearch search = searchWithin(limits, pair.rounding);
  search.visits = answer.visits;
  if (isPairOf(pair, start)) {
    measureTriangles(pair, start, search.bounds, search);
  }
  NodePairQueue queue(memory);
  queue.push({0.0F, 0, 0});
  searchPairs(pair, limits.visit_budget, queue, search);
  answer = answerOf(pair, search, a.world_from_mesh, limits.stop_beyond);
  reportContainment(pair, a.world_from_mesh, limits, memory, {}, answer);
  return answer;
}

MeshDistance distanceBetween(const PlacedMesh& a, const PlacedMesh& b, MeshQueryMemory& memory,
                             MeshFront& front, const MeshQueryLimits& limits) noexcept {
  if (!isFinite(a.world_from_mesh) || !isFinite(b.world_from_mesh)) {
    return {};
  }
  const MeshPair pair = makeMeshPair(a, b);
  const MeshQuery query{pair};
  MeshDistance answer;
  if (isStillHeld(pair, a.world_from_mesh, limits, memory, answer)) {
    front.apart = front.outside = 0.0;
    return answer;
  }
  NearestSearch search = searchWithin(limits, pair.rounding);
  search.visits = answer.visits;
  search.front = &front;
  search.moving = movingBounds(pair.b, false);
  const double step =
      follow({pair.a_from_b, pair.b, pair.a.center(), pair.a.radius(), 1.0, pair.rounding}, front);
  NodePairQueue queue(memory);
  searchFromFront(query, step, pair.rounding, limits.visit_budget, queue, search);
  answer = answerOf(pair, search, a.world_from_mesh, limits.stop_beyond);
  if (step < std::min(front.apart, front.outside)) {
    answer.outside = front.outside - step;
  } else {
    reportContainment(pair, a.world_from_mesh, limits, memory, front.probes, answer);
  }
  front.apart = answer.state == MeshState::overlapping ? 0.0 : answer.measured.distance;
  front.outside = limits.asks_outside ? answer.outside : 0.0;
  return answer;
}

}  // namespace collision_monitor
