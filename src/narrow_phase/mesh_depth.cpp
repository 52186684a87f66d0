// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/narrow_phase/mesh_depth.h"

#include <algorithm>
#include <array>

#include "narrow_phase/core_distance.h"
#include "narrow_phase/mesh_search.h"
#include "narrow_phase/mesh_support.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

// A bound of A whose corners may be deep in B by `potential` at most.
struct Promise {
  Slot slot;
  double potential;
  std::uint32_t nearest;  // triangle of B nearest to its centre
};

constexpr std::size_t kPromises = MeshQueryMemory::kCapacity;

// The search for the corner of one mesh that is deepest in the other.
struct DepthSearch {
  const PlacedMesh& corners_of;
  const PlacedMesh& solid;
  MeshQueryMemory& memory;
  std::uint32_t budget;
  SignedDistance deepest;  // from the solid to the corner; distance <= 0
  std::array<Promise, kPromises> promises;
  std::size_t size{0};
};

// Signed distance of the solid to a point. Without a limit, beyond which depths would be cut off
// too.
MeshDistance measurePoint(DepthSearch& search, const Vector3d& point,
                          std::uint32_t start) noexcept {
  const Shape shape = Sphere{};
  const Pose pose{Eigen::Matrix3d::Identity(), point};
  search.budget -= search.budget > 0 ? 1 : 0;
  return distanceBetween(search.solid, {shape, pose}, search.memory, {start, TrianglePair::kNone});
}

void measureCorners(DepthSearch& search, const Promise& promise) noexcept {
  const std::uint32_t triangle = triangleAt(childOf(search.corners_of.tree, promise.slot));
  for (const Vector3d& corner : search.corners_of.tree.triangles()[triangle]) {
    const MeshDistance found =
        measurePoint(search, search.corners_of.world_from_mesh * corner, promise.nearest);
    if (found.state == MeshState::overlapping &&
        found.measured.distance < search.deepest.distance) {
      search.deepest = found.measured;
    }
  }
}

// The signed distance at the centre of a bound, less what its size can make of it.
Promise promiseOf(DepthSearch& search, Slot slot, std::uint32_t start) noexcept {
  const MeshTree& tree = search.corners_of.tree;
  const Bound bound = boundAt(tree, slot);
  const Vector3d center = tree.center() + bound.center.cast<double>();
  const double radius = bound.half.cast<double>().norm();
  const MeshDistance found =
      measurePoint(search, search.corners_of.world_from_mesh * center, start);
  return {slot, radius - found.measured.distance, found.nearest.a};
}

// Leaves the children that may hold a deeper corner waiting, the most promising on top.
void openNode(DepthSearch& search, const Promise& promise) noexcept {
  const std::uint32_t node = childOf(search.corners_of.tree, promise.slot);
  const std::size_t bottom = search.size;
  for (std::uint32_t i = 0; i < MeshTreeNode::kWidth; ++i) {
    if (search.corners_of.tree.nodes()[node].child[i] == MeshTreeNode::kNone) {
      continue;
    }
    const Promise child = promiseOf(search, (node << kSlotBits) + i, promise.nearest);
    if (child.potential > -search.deepest.distance) {
      search.promises[search.size++] = child;
    }
  }
  std::sort(search.promises.begin() + bottom, search.promises.begin() + search.size,
            [](const Promise& x, const Promise& y) { return x.potential < y.potential; });
}

void searchDeepest(DepthSearch& search) noexcept {
  search.promises[search.size++] = promiseOf(search, 0, TrianglePair::kNone);
  while (search.size > 0 && search.budget > 0) {
    const Promise promise = search.promises[--search.size];
    if (!(promise.potential > -search.deepest.distance)) {
      continue;
    }
    if (isTriangle(childOf(search.corners_of.tree, promise.slot))) {
      measureCorners(search, promise);
    } else {
      openNode(search, promise);
    }
  }
}

// The deepest corner of `corners_of` in `solid`; false when the budget did not suffice.
bool findDeepest(const PlacedMesh& corners_of, const PlacedMesh& solid, std::uint32_t budget,
                 MeshQueryMemory& memory, SignedDistance& deepest) noexcept {
  if (!solid.tree.isClosed()) {
    return true;
  }
  DepthSearch search{corners_of, solid, memory, budget, {}, {}, 0};
  searchDeepest(search);
  deepest = search.deepest;
  return search.size == 0;
}

// How far B has to go along a unit direction to be off A.
void tryWayOut(const PlacedMesh& a, const PlacedMesh& b, const Vector3d& direction,
               MeshPenetration& found) noexcept {
  const double length = direction.dot(farthestAlong(a, direction) - farthestAlong(b, -direction));
  if (length < found.at_most) {
    found.at_most = length;
    found.way_out = direction;
  }
}

void tryWaysOut(const PlacedMesh& a, const PlacedMesh& b, MeshPenetration& found) noexcept {
  const Vector3d between =
      b.world_from_mesh * b.tree.center() - a.world_from_mesh * a.tree.center();
  if (between.norm() > kNear) {
    tryWayOut(a, b, between.normalized(), found);
  }
  if (found.at_least > 0.0) {
    tryWayOut(a, b, found.deepest.normal_a_to_b, found);
  }
  for (const Eigen::Matrix3d& axes : {a.world_from_mesh.rotation, b.world_from_mesh.rotation}) {
    for (Eigen::Index k = 0; k < 3; ++k) {
      tryWayOut(a, b, axes.col(k), found);
      tryWayOut(a, b, -axes.col(k), found);
    }
  }
}

}  // namespace

MeshPenetration penetrationOf(const PlacedMesh& a, const PlacedMesh& b, MeshQueryMemory& memory,
                              std::uint32_t point_budget) noexcept {
  MeshPenetration found;
  if (!isFinite(a.world_from_mesh) || !isFinite(b.world_from_mesh)) {
    return found;
  }
  SignedDistance of_a;  // from B's solid to a corner of A
  SignedDistance of_b;
  const bool is_complete_a = findDeepest(a, b, point_budget, memory, of_a);
  const bool is_complete_b = findDeepest(b, a, point_budget, memory, of_b);
  found.is_complete = is_complete_a && is_complete_b;
  found.deepest = of_a.distance < of_b.distance ? swapped(of_a) : of_b;
  found.at_least = -found.deepest.distance;
  tryWaysOut(a, b, found);
  return found;
}

}  // namespace collision_monitor
