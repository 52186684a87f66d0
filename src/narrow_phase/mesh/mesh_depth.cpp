// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/narrow_phase/mesh_depth.h"

#include <algorithm>
#include <cmath>

#include "geometry/ball_motion.h"
#include "narrow_phase/core_distance.h"
#include "narrow_phase/mesh/mesh_inside.h"
#include "narrow_phase/mesh/mesh_search.h"
#include "narrow_phase/mesh/point_on_mesh.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

// [m] What has moved by less has not.
constexpr double kStill = 1e-9;
// Points that a query measures while there are any left: as many after a step as long as the depth,
// or as a share of the smaller mesh where that is more; fewer after a shorter one, but some always.
constexpr std::uint32_t kFewestPoints = 4;
constexpr double kPointsAStep = 120.0;
constexpr double kLeastShare = 0.02;

// A corner of one mesh in the solid of the other. Frames: the solid's.
struct DeepCorner {
  KeptDepth::Corner corner;
  double depth{0.0};  // [m]
  Vector3d at{Vector3d::Zero()};
  Vector3d on_surface{Vector3d::Zero()};
};

// The search for the corner of one mesh that is deepest in the solid of the other. Frames: the
// solid's.
struct DepthSearch {
  const MeshTree& mesh;
  const MeshTree& solid;
  Pose solid_from_mesh;
  MeshQueryMemory& memory;
  KeptDepth::Side& side;
  DeepCorner deepest{};
  double beyond{0.0};       // [m] what is not deeper does not count
  std::uint32_t points{0};  // measured
};

// What is left of a place that may have corners within the radius that are deep enough to count.
struct MeasuredPlace {
  bool is_deep{false};
  double distance{0.0};  // signed, of its centre
  PointOnMesh nearest;
};

// No point is deeper in the solid than in the box about it.
double depthInBox(const MeshTree& solid, const Vector3d& point) noexcept {
  const Bound box = boundAt(solid, 0);
  const Vector3d from_center = point - solid.center() - box.center.cast<double>();
  return (box.half.cast<double>() - from_center.cwiseAbs()).minCoeff();
}

bool isPointInside(const DepthSearch& search, const Vector3d& point) noexcept {
  const bool is_about_deepest = (point - search.deepest.at).norm() < search.deepest.depth;
  return is_about_deepest || isInside(search.solid, point, search.memory);
}

MeasuredPlace measurePlace(DepthSearch& search, const Vector3d& center, double radius,
                           std::uint32_t start) noexcept {
  MeasuredPlace found;
  const double in_box = depthInBox(search.solid, center);
  if (!(radius + in_box > search.beyond)) {
    return found;
  }
  const double enough = std::max(search.beyond - radius, 0.0);
  found.nearest = nearestOnMesh(search.solid, center, start, {enough}, search.memory);
  search.points += found.nearest.visits > 0 ? 1 : 0;
  found.distance = found.nearest.distance;
  if (!(radius + found.distance > search.beyond)) {
    return found;
  }
  if (in_box > 0.0 && isPointInside(search, center)) {
    found.distance = -found.distance;
  }
  found.is_deep = radius - found.distance > search.beyond;
  return found;
}

void measureCorner(DepthSearch& search, const KeptDepth::Corner& corner) noexcept {
  const Vector3d at = search.solid_from_mesh * search.mesh.triangles()[corner.triangle][corner.at];
  const MeasuredPlace found = measurePlace(search, at, 0.0, corner.nearest);
  if (found.is_deep) {
    search.beyond = -found.distance;
    search.deepest = {{corner.triangle, corner.at, found.nearest.triangle},
                      search.beyond,
                      at,
                      found.nearest.point};
  }
}

Vector3d centerOf(const DepthSearch& search, const Bound& bound) noexcept {
  return search.solid_from_mesh * (search.mesh.center() + bound.center.cast<double>());
}

// Lets the children wait, on top the one that lies deepest behind the surface near their centre.
void openNode(DepthSearch& search, std::uint32_t node, const Vector3d& center,
              const MeasuredPlace& found) noexcept {
  const Vector3d inwards = found.distance * (found.nearest.point - center);
  const std::uint32_t bottom = search.side.size;
  std::array<double, MeshTreeNode::kWidth> heights;
  for (std::uint32_t i = 0; i < MeshTreeNode::kWidth; ++i) {
    if (search.mesh.nodes()[node].child[i] == MeshTreeNode::kNone) {
      continue;
    }
    const Slot slot = (node << kSlotBits) + i;
    const double height = inwards.dot(centerOf(search, boundAt(search.mesh, slot)));
    std::uint32_t place = search.side.size++;
    for (; place > bottom && heights[place - 1 - bottom] > height; --place) {
      search.side.waiting[place] = search.side.waiting[place - 1];
      heights[place - bottom] = heights[place - 1 - bottom];
    }
    search.side.waiting[place] = {slot, found.nearest.triangle};
    heights[place - bottom] = height;
  }
}

void searchDeepest(DepthSearch& search, std::uint32_t point_budget) noexcept {
  while (search.side.size > 0 && search.points < point_budget) {
    const KeptDepth::Waiting next = search.side.waiting[--search.side.size];
    const Bound bound = boundAt(search.mesh, next.bound);
    const Vector3d center = centerOf(search, bound);
    const double radius = bound.half.cast<double>().norm();
    const MeasuredPlace found = measurePlace(search, center, radius, next.nearest);
    const std::uint32_t child = childOf(search.mesh, next.bound);
    if (found.is_deep && isTriangle(child)) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        measureCorner(search, {triangleAt(child), i, found.nearest.triangle});
      }
    } else if (found.is_deep) {
      openNode(search, child, center, found);
    }
  }
}

// Both ways round: corners of A in B, and of B in A.
using BothWays = std::array<DepthSearch, 2>;

bool isComplete(const KeptDepth& kept) noexcept {
  return kept.sides[0].size == 0 && kept.sides[1].size == 0;
}

// [m] How far any point of B may have come, seen from A, since the last query.
double follow(const MeshTree& b, const Pose& a_from_b, KeptDepth& kept) noexcept {
  const double step = kept.a_from_b ? motionOfBall(b.center(), b.radius(), *kept.a_from_b, a_from_b)
                                    : std::numeric_limits<double>::infinity();
  kept.a_from_b = a_from_b;
  kept.moved += step;
  return step;
}

// The corner that was the deepest.
void measureKept(BothWays& ways, const KeptDepth& kept) noexcept {
  if (kept.deepest.triangle != TrianglePair::kNone) {
    measureCorner(ways[kept.side], kept.deepest);
  }
  ways[0].beyond = ways[1].beyond = ways[kept.side].deepest.depth;
}

// [m] A step of this length, and the deepest corner may be any other.
double longStep(const BothWays& ways) noexcept {
  return std::max(ways[0].beyond,
                  kLeastShare * std::min(ways[0].mesh.radius(), ways[1].mesh.radius()));
}

std::uint32_t pointsFor(double share, std::uint32_t point_budget) noexcept {
  const double points = share < 1.0 ? share * kPointsAStep : point_budget;
  return std::min(point_budget, std::max(kFewestPoints, static_cast<std::uint32_t>(points)));
}

void startFromRoots(const BothWays& ways, KeptDepth& kept) noexcept {
  for (std::size_t i = 0; i < 2; ++i) {
    kept.sides[i].size = ways[i].solid.isClosed() ? 1 : 0;
    kept.sides[i].waiting[0] = {0, TrianglePair::kNone};
  }
  kept.moved = 0.0;
}

void searchBothWays(std::uint32_t point_budget, BothWays& ways, KeptDepth& kept) noexcept {
  searchDeepest(ways[0], kept.sides[1].size > 0 ? point_budget / 2 : point_budget);
  ways[1].beyond = ways[0].beyond;
  searchDeepest(ways[1], point_budget - std::min(point_budget, ways[0].points));
  kept.side = ways[1].deepest.depth > ways[0].deepest.depth ? 1 : 0;
  kept.deepest = ways[kept.side].deepest.corner;
}

// In A's frame, from its surface to that of B.
SignedDistance answerOf(const BothWays& ways, std::size_t side, const Pose& a_from_b) noexcept {
  const DeepCorner& found = ways[side].deepest;
  if (!(found.depth > 0.0)) {
    return {};
  }
  const SignedDistance to_corner{-found.depth, found.on_surface, found.at,
                                 (found.on_surface - found.at) / found.depth};
  return side == 1 ? to_corner : swapped(placed(a_from_b, to_corner));
}

}  // namespace

MeshDepth depthOf(const PlacedMesh& a, const PlacedMesh& b, MeshQueryMemory& memory,
                  KeptDepth& kept, std::uint32_t point_budget) noexcept {
  if (!isFinite(a.world_from_mesh) || !isFinite(b.world_from_mesh)) {
    return {};
  }
  const Pose a_from_b = inverse(a.world_from_mesh) * b.world_from_mesh;
  const bool stands = kept.a_from_b && isSame(*kept.a_from_b, a_from_b);
  MeshDepth answer;
  if (!stands || kept.moved > kStill || !isComplete(kept)) {
    BothWays ways = {
        DepthSearch{a.tree, b.tree, inverse(a_from_b), memory, kept.sides[0]},
        DepthSearch{b.tree, a.tree, a_from_b, memory, kept.sides[1]},
    };
    const double step = follow(b.tree, a_from_b, kept);
    measureKept(ways, kept);
    const double share = step / longStep(ways);
    if (!(share < 1.0) || (isComplete(kept) && kept.moved > kStill)) {
      startFromRoots(ways, kept);
    }
    searchBothWays(pointsFor(share, point_budget), ways, kept);
    answer.points = ways[0].points + ways[1].points;
    kept.in_a = answerOf(ways, kept.side, a_from_b);
  }
  answer.is_complete = isComplete(kept) && kept.moved <= kStill;
  answer.deepest = placed(a.world_from_mesh, kept.in_a);
  return answer;
}

void forget(KeptDepth& kept) noexcept {
  kept.a_from_b.reset();
  kept.deepest = KeptDepth::Corner();
  kept.in_a = SignedDistance();
}

}  // namespace collision_monitor
