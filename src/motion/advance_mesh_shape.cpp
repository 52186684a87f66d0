// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "collision_monitor/geometry/ids.h"
#include "motion/advance.h"
#include "narrow_phase/gjk/convex_core.h"
#include "narrow_phase/mesh/mesh_and_core.h"
#include "narrow_phase/triangle/triangle_core.h"

namespace collision_monitor {
namespace {

/// Searches a mesh for the triangles that may first come within the contact distance of a shape.
/// The mesh moves. Frames: the shape's.
struct TriangleSweep {
  const MeshAndCore& pair;
  Approach approach;
  double nearest;          ///< [m] between core and triangle: in contact
  double tolerance;        ///< [m] as SweepLimits
  double soonest;          ///< from the current time on
  Eigen::Vector3d normal;  ///< unit, from the shape to the mesh: of the last measured
};

/// [m] How far a triangle lies beyond the core along a unit vector.
double gapAlong(const Eigen::Vector3d& n, const Triangle& triangle,
                const MeshAndCore& pair) noexcept {
  const double start = std::min({n.dot(triangle[0]), n.dot(triangle[1]), n.dot(triangle[2])});
  return start - n.cwiseAbs().dot(pair.core.half_extents);
}

/// How long a plane across a unit vector keeps the triangle from the shape; 0 if none does.
double timeAlong(const Eigen::Vector3d& n, const Triangle& triangle,
                 const TriangleSweep& sweep) noexcept {
  const double gap = gapAlong(n, triangle, sweep.pair) - sweep.nearest;
  return gap > sweep.tolerance ? timeAcross(n, gap, triangle, sweep.approach) : 0.0;
}

/// @return the work.
std::uint32_t measureTriangle(std::uint32_t index, TriangleSweep& sweep) noexcept {
  constexpr std::uint32_t kWork = 8;  // of a box; segments take less
  const Triangle triangle = triangleInCore(sweep.pair, index);
  if (!(timeAlong(sweep.normal, triangle, sweep) < sweep.soonest)) {
    return 1;
  }
  const PointPair points = nearestPoints(triangle, sweep.pair.core, PointPair());
  const double distance = std::sqrt(points.squared_distance);
  if (distance > 0.0) {
    sweep.normal = (points.on_a - points.on_b) / distance;
  }
  sweep.soonest = std::min(sweep.soonest, timeAlong(sweep.normal, triangle, sweep));
  return kWork;
}

/// [m^2] Nodes farther from the core than this cannot meet it before `soonest`.
double squaredReach(const TriangleSweep& sweep, Slot slot) noexcept {
  const Bound bound = boundAt(sweep.pair.mesh, slot);
  const Eigen::Vector3d center =
      sweep.pair.core_from_mesh * (sweep.pair.mesh.center() + bound.center.cast<double>());
  const Consumption motion = ofBall(sweep.approach, center, bound.half.cast<double>().norm());
  const double reach = sweep.nearest + sweep.tolerance + motion.within(sweep.soonest);
  return reach * reach;
}

/// @return the work; more than `budget` if it was spent.
std::uint32_t search(MeshQueryMemory& memory, std::uint32_t budget, TriangleSweep& sweep) noexcept {
  std::uint32_t work = 0;
  NodePairQueue queue(memory);
  queue.push({0.0F, 0, 0});
  while (!queue.empty() && sweep.soonest > 0.0 && work <= budget) {
    const MeshQueryMemory::NodePair next = queue.pop();
    const float limit = asLimit(squaredReach(sweep, next.a));
    if (!(next.squared_bound < limit)) {
      continue;
    }
    ++work;
    const std::uint32_t child = childOf(sweep.pair.mesh, next.a);
    if (isTriangle(child)) {
      work += measureTriangle(triangleAt(child), sweep);
    } else {
      OpenedPair opened;
      choose(sweep.pair, next.a, opened);
      boundChildren(limit, opened);
      queue.pushNearer(opened);
    }
  }
  return work;
}

/// How long no triangle comes within the contact distance: planes part them for longer than their
/// distance tells where surfaces slide past each other. 0 if the budget ends the search.
double timeByTriangles(const MovingMesh& a, const MovingShape& b, const SweepLimits& limits,
                       const Sighting& seen, MeshQueryMemory& memory,
                       SweptContact& found) noexcept {
  const Pose world_from_a = poseAt(a.motion, found.time);
  const Pose world_from_b = poseAt(b.motion, found.time);
  const ConvexCore core{ConvexCore::Kind::box, coreHalfExtents(b.shape)};
  const MeshAndCore pair =
      makeMeshAndCore({a.tree, world_from_a}, {core, radiusOf(b.shape)}, world_from_b);
  const Approach approach = approachAt(b.motion, a.motion, ballOf(a.tree), found.time);
  double rest = limits.until - found.time;
  if (std::isfinite(seen.outside)) {
    // Points of the shape go inside an open mesh.
    const Approach of_shape = approachAt(a.motion, b.motion, ballOf(b.shape), found.time);
    rest = std::min(
        rest, timeToConsume(seen.outside, ofBall(of_shape, of_shape.center, of_shape.radius)));
  }
  TriangleSweep sweep{pair,
                      placedInA(approach, world_from_b),
                      nearestOf(limits) + pair.radius,
                      limits.tolerance,
                      rest,
                      world_from_b.rotation.transpose() * -seen.measured.normal_a_to_b};
  const std::uint32_t left = limits.budget - std::min(limits.budget, found.work);
  const std::uint32_t work = search(memory, left, sweep);
  found.work += work;
  return work <= left ? sweep.soonest : 0.0;
}

Sighting sight(const MeshDistance& found, const SweepLimits& limits) noexcept {
  Sighting seen;
  seen.work = found.visits + 1;
  seen.measured = found.measured;
  seen.gap = found.measured.distance - nearestOf(limits);
  const bool is_near = found.state == MeshState::overlapping || seen.gap <= limits.tolerance;
  seen.gap = std::min(seen.gap, found.outside);
  seen.outside = found.outside;
  if (found.state == MeshState::unknown) {
    seen.state = SweepState::unknown;
  } else if (!is_near) {
    seen.state = SweepState::clear;
  } else {
    seen.state =
        found.state == MeshState::lower_bound ? SweepState::undecided : SweepState::contact;
  }
  return seen;
}

}  // namespace

SweptContact firstContact(const MovingMesh& a, const MovingShape& b, const SweepLimits& limits,
                          MeshQueryMemory& memory) noexcept {
  const Ball ball_a = ballOf(a.tree);
  const Ball ball_b = ballOf(b.shape);
  const double nearest = nearestOf(limits);
  TrianglePair start;
  const auto look = [&](double time, std::uint32_t budget) noexcept {
    const Approach approach = approachAt(a.motion, b.motion, ball_b, time);
    MeshQueryLimits query;
    query.visit_budget = budget;
    // Bodies farther apart than this cannot come into contact in the rest of the interval.
    query.stop_beyond =
        nearest + 2.0 * limits.tolerance +
        ofBall(approach, approach.center, approach.radius).within(limits.until - time);
    const Pose world_from_a = poseAt(a.motion, time);
    const Pose world_from_b = poseAt(b.motion, time);
    const MeshDistance found = distanceBetween(
        PlacedMesh{a.tree, world_from_a}, PlacedShape{b.shape, world_from_b}, memory, start, query);
    start = found.nearest;
    return sight(found, limits);
  };
  const auto lasts = [&](double step, const Sighting& seen, SweptContact& found) noexcept {
    return std::max(step, timeByTriangles(a, b, limits, seen, memory, found));
  };
  return advance({ball_a, a.motion}, {ball_b, b.motion}, limits, look, lasts);
}

}  // namespace collision_monitor
