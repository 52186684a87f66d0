// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/mesh_depth/mesh_depth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision_monitor/geometry/ids.h"
#include "geometry/ball_motion.h"
#include "narrow_phase/closed_form/core_distance.h"
#include "narrow_phase/mesh_depth/depth_front.h"
#include "narrow_phase/mesh_depth/depth_search.h"

namespace collision_monitor {
namespace {

// Points that a query measures if any are left. A step as long as the depth, or as a share of the
// smaller mesh if that is more, gets kPointsAStep. A shorter one gets fewer, but some always.
constexpr std::uint32_t kFewestPoints = 4;
constexpr double kPointsAStep = 120.0;
constexpr double kLeastShare = 0.02;
// [m] Limits contain the travel so far. After more travel they would round by more than depths do.
constexpr double kLongestTravel = 1000.0;

// Both directions: corners of A in B, and of B in A.
using BothSides = std::array<DepthSearch, 2>;

bool hasOpenNodes(const KeptDepth& kept) noexcept {
  return kept.sides[0].open_count > 0 || kept.sides[1].open_count > 0;
}

// What was dropped is known only at the poses where the search began.
bool isComplete(const KeptDepth& kept) noexcept {
  const bool is_whole = kept.sides[0].is_whole && kept.sides[1].is_whole;
  return !hasOpenNodes(kept) && (is_whole || kept.moved <= kDepthRounding);
}

// [m] Upper bound of how far any point of B has moved since the last query, seen from A.
double follow(const MeshTree& b, const Pose& a_from_b, KeptDepth& kept) noexcept {
  const double step = kept.a_from_b ? motionOfBall(b.center(), b.radius(), *kept.a_from_b, a_from_b)
                                    : std::numeric_limits<double>::infinity();
  kept.a_from_b = a_from_b;
  kept.moved += step;
  return step;
}

// Measures the corner that was the deepest. It is still inside after a step below half its depth.
void measureKept(double step, BothSides& both, const KeptDepth& kept) noexcept {
  both[0].moved = both[1].moved = kept.moved;
  if (kept.deepest.bound != kNone) {
    const bool is_inside = step < -0.5 * kept.in_a.distance;
    measureDeepest(kept.deepest, is_inside, both[kept.side]);
  }
  both[0].beyond = both[1].beyond = both[kept.side].deepest.depth;
}

// [m] After a step of this length any other corner may be the deepest.
double longStep(const BothSides& both) noexcept {
  return std::max(both[0].beyond,
                  kLeastShare * std::min(both[0].mesh.radius(), both[1].mesh.radius()));
}

std::uint32_t pointsFor(double share, std::uint32_t point_budget) noexcept {
  const double points = share < 1.0 ? share * kPointsAStep : point_budget;
  return std::min(point_budget, std::max(kFewestPoints, static_cast<std::uint32_t>(points)));
}

void restart(BothSides& both, KeptDepth& kept) noexcept {
  for (std::size_t i = 0; i < 2; ++i) {
    restart(both[i].solid.hasInside(), kept.sides[i]);
  }
  both[0].moved = both[1].moved = kept.moved = 0.0;
}

void searchBothSides(std::uint32_t point_budget, BothSides& both, KeptDepth& kept) noexcept {
  searchDeepest(kept.sides[1].open_count > 0 ? point_budget / 2 : point_budget, both[0]);
  both[1].beyond = both[0].beyond;
  searchDeepest(point_budget - std::min(point_budget, both[0].points), both[1]);
  kept.side = both[1].deepest.depth > both[0].deepest.depth ? 1 : 0;
  kept.deepest = both[kept.side].deepest.corner;
  passOverDeepest(both[1 - kept.side]);
}

// In A's frame, from A's surface to B's.
SignedDistance answerOf(const BothSides& both, std::size_t side, const Pose& a_from_b) noexcept {
  const DeepCorner& found = both[side].deepest;
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
  if (!stands || !isComplete(kept)) {
    BothSides both = {
        DepthSearch{a.tree, b.tree, inverse(a_from_b), memory, kept.sides[0]},
        DepthSearch{b.tree, a.tree, a_from_b, memory, kept.sides[1]},
    };
    const double step = follow(b.tree, a_from_b, kept);
    measureKept(step, both, kept);
    const double share = step / longStep(both);
    const bool is_spent = kept.moved > kLongestTravel || !(hasOpenNodes(kept) || isComplete(kept));
    if (!(share < 1.0) || is_spent) {
      restart(both, kept);
    }
    searchBothSides(pointsFor(share, point_budget), both, kept);
    answer.points = both[0].points + both[1].points;
    answer.visits = both[0].visits + both[1].visits;
    kept.in_a = answerOf(both, kept.side, a_from_b);
  }
  answer.is_complete = isComplete(kept);
  answer.deepest = placed(a.world_from_mesh, kept.in_a);
  return answer;
}

void forget(KeptDepth& kept) noexcept {
  kept.a_from_b.reset();
  kept.deepest = KeptDepth::Corner();
  kept.in_a = SignedDistance();
}

}  // namespace collision_monitor
