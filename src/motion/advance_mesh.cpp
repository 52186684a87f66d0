// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "collision_monitor/geometry/ids.h"
#include "motion/advance.h"
#include "narrow_phase/closed_form/core_distance.h"
#include "narrow_phase/mesh/mesh_search.h"
#include "narrow_phase/triangle/triangle_edges.h"

namespace collision_monitor {
namespace {

using NodePair = MeshQueryMemory::NodePair;

/// Searches two meshes at one time, in the frame of A, for the earliest time at which two of their
/// triangles may come within the contact distance.
struct Sweep {
  const MeshPair& pair;
  Approach approach;
  const SweepLimits& limits;
  double soonest;  ///< from the current time on
  TrianglePair nearest;
  PointPair contact;  ///< of `nearest`, when in contact
  bool is_contact{false};
  Eigen::Vector3d normal{Eigen::Vector3d::Zero()};  ///< unit, from A to B: of the last measured
};

/// Whether the last normal proves that two triangles meet no sooner than others. It mostly does
/// where surfaces slide past each other.
bool areLater(const Triangle& of_a, const Triangle& of_b, const Sweep& sweep) noexcept {
  const Eigen::Vector3d& n = sweep.normal;
  const double gap = std::min({n.dot(of_b[0]), n.dot(of_b[1]), n.dot(of_b[2])}) -
                     std::max({n.dot(of_a[0]), n.dot(of_a[1]), n.dot(of_a[2])}) -
                     nearestOf(sweep.limits);
  return gap > sweep.limits.tolerance &&
         !(timeAcross(n, gap, of_b, sweep.approach) < sweep.soonest);
}

/// @return the work.
std::uint32_t measureTriangles(std::uint32_t a, std::uint32_t b, Sweep& sweep) noexcept {
  const Triangle& of_a = sweep.pair.a.triangles()[a];
  const Triangle in_a = triangleOfB(sweep.pair, b);
  if (areLater(of_a, in_a, sweep)) {
    return 1;
  }
  const PointPair points = nearestPoints(of_a, in_a);
  const double distance = std::sqrt(points.squared_distance);
  const double gap = distance - nearestOf(sweep.limits);
  if (gap <= sweep.limits.tolerance) {
    sweep.is_contact = true;
    sweep.nearest = {a, b};
    sweep.contact = points;
    return kVisitsToMeasure;
  }
  sweep.normal = (points.on_b - points.on_a) / distance;
  const double time = timeAcross(sweep.normal, gap, in_a, sweep.approach);
  if (time < sweep.soonest) {
    sweep.soonest = time;
    sweep.nearest = {a, b};
  }
  return kVisitsToMeasure;
}

/// The ball about the content of a slot of B, in the frame of A. A triangle has its node's ball.
Ball ballAt(const MeshPair& pair, Slot slot) noexcept {
  const Bound bound = boundAt(pair.b, slot);
  return {pair.a_from_b * (pair.b.center() + bound.center.cast<double>()),
          bound.half.cast<double>().norm()};
}

/// [m^2] Bounds farther apart than this cannot meet before `soonest`.
double squaredReach(const Sweep& sweep, Slot slot_of_b) noexcept {
  const Ball ball = ballAt(sweep.pair, slot_of_b);
  const double reach = nearestOf(sweep.limits) + sweep.limits.tolerance +
                       ofBall(sweep.approach, ball.center, ball.radius).within(sweep.soonest);
  return reach * reach;
}

/// @return the work: nodes opened and triangles measured; more than `budget` if it was spent.
std::uint32_t search(MeshQueryMemory& memory, std::uint32_t budget, Sweep& sweep) noexcept {
  std::uint32_t work = 0;
  NodePairQueue queue(memory);
  queue.push({0.0F, 0, 0});
  while (!queue.empty() && !sweep.is_contact) {
    const NodePair next = queue.pop();
    const float limit = asLimit(squaredReach(sweep, next.b));
    if (!(next.squared_bound < limit)) {
      continue;
    }
    if (++work > budget) {
      return work;
    }
    const std::uint32_t child_a = childOf(sweep.pair.a, next.a);
    const std::uint32_t child_b = childOf(sweep.pair.b, next.b);
    if (isTriangle(child_a) && isTriangle(child_b)) {
      work += measureTriangles(triangleAt(child_a), triangleAt(child_b), sweep) - 1;
    } else {
      openLarger(sweep.pair, next, limit, queue);
    }
  }
  return work;
}

/// Whether one mesh is inside the other, where it can enter through a hole. If not, until when that
/// is certain.
Holding lookInside(MeshQueryMemory& memory, Sweep& sweep) noexcept {
  if (!sweep.pair.a.openSurface() && !sweep.pair.b.openSurface()) {
    return {};
  }
  Holding held = pointHeld(sweep.pair, memory, {});
  if (std::isfinite(held.outside)) {
    const Approach& approach = sweep.approach;
    const Consumption motion = ofBall(approach, approach.center, approach.radius);
    sweep.soonest = std::min(sweep.soonest, timeToConsume(held.outside, motion));
  }
  return held;
}

/// The normal of one of two triangles that touch: the one that parts them best, from A to B.
Eigen::Vector3d normalOfTouch(const Triangle& a, const Triangle& b) noexcept {
  Eigen::Vector3d best = Eigen::Vector3d::UnitX();
  double widest = -std::numeric_limits<double>::infinity();
  for (const Triangle* triangle : {&a, &b}) {
    const Eigen::Vector3d normal = anyNormalOf(prepare(*triangle));
    for (const Eigen::Vector3d& n : {normal, Eigen::Vector3d(-normal)}) {
      const double gap = std::min({n.dot(b[0]), n.dot(b[1]), n.dot(b[2])}) -
                         std::max({n.dot(a[0]), n.dot(a[1]), n.dot(a[2])});
      best = gap > widest ? n : best;
      widest = std::max(widest, gap);
    }
  }
  return best;
}

SignedDistance contactOf(const Sweep& sweep, const Pose& world_from_a) noexcept {
  const double distance = std::sqrt(sweep.contact.squared_distance);
  const Eigen::Vector3d normal =
      distance > kTouching ? Eigen::Vector3d((sweep.contact.on_b - sweep.contact.on_a) / distance)
                           : normalOfTouch(sweep.pair.a.triangles()[sweep.nearest.a],
                                           triangleOfB(sweep.pair, sweep.nearest.b));
  return placed(world_from_a, {distance, sweep.contact.on_a, sweep.contact.on_b, normal});
}

/// The state between two steps.
struct Progress {
  SweptContact found;
  TrianglePair last;  ///< the pair that limited the last step
};

SignedDistance contactAt(const Eigen::Vector3d& point) noexcept {
  SignedDistance contact;
  contact.distance = 0.0;
  contact.point_on_a = contact.point_on_b = point;
  return contact;
}

/// @return false when the budget ended the step.
bool advanceOnce(const MovingMesh& a, const MovingMesh& b, const SweepLimits& limits,
                 MeshQueryMemory& memory, Progress& progress) noexcept {
  SweptContact& found = progress.found;
  const Pose world_from_a = poseAt(a.motion, found.time);
  const Pose world_from_b = poseAt(b.motion, found.time);
  const MeshPair pair = makeMeshPair({a.tree, world_from_a}, {b.tree, world_from_b});
  const Approach approach = approachAt(a.motion, b.motion, ballOf(b.tree), found.time);
  const double rest = limits.until - found.time;
  Sweep sweep{pair,   placedInA(approach, world_from_a),
              limits, rest,
              {},     {},
              false,  Eigen::Vector3d::Zero()};
  if (progress.last.a != kNone) {
    measureTriangles(progress.last.a, progress.last.b, sweep);
  }
  const std::uint32_t left = limits.budget - found.work;
  const std::uint32_t work = search(memory, left, sweep);
  found.work += work;
  progress.last = sweep.nearest;
  if (sweep.is_contact) {
    found.state = SweepState::contact;
    found.measured = contactOf(sweep, world_from_a);
  } else if (work <= left) {
    const Holding held = lookInside(memory, sweep);
    found.work += held.visits;
    if (held.point) {
      found.state = SweepState::contact;
      found.measured = contactAt(world_from_a * *held.point);
    } else if (sweep.nearest.a == kNone && !(sweep.soonest < rest)) {
      found.state = SweepState::clear;
      found.time = 1.0;
    } else {
      found.time += sweep.soonest;
    }
  }
  return work <= left;
}

}  // namespace

Ball ballOf(const MeshTree& tree) noexcept { return {tree.center(), tree.radius()}; }

SweptContact firstContact(const MovingMesh& a, const MovingMesh& b, const SweepLimits& limits,
                          MeshQueryMemory& memory) noexcept {
  // The points of the smaller body stand for both, because their speeds differ least.
  if (a.tree.radius() < b.tree.radius()) {
    SweptContact found = firstContact(b, a, limits, memory);
    found.measured = swapped(found.measured);
    return found;
  }
  SweptContact found;
  if (!isFinite(a.motion) || !isFinite(b.motion)) {
    return found;
  }
  found.state = SweepState::undecided;
  found.time = limits.from;
  Progress progress{found, {}};
  while (progress.found.state == SweepState::undecided && progress.found.work < limits.budget &&
         advanceOnce(a, b, limits, memory, progress)) {
  }
  return progress.found;
}

}  // namespace collision_monitor
