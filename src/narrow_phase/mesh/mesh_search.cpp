// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/mesh/mesh_search.h"

#include <algorithm>

namespace collision_monitor {
namespace {

float sizeOf(const MeshTree& tree, Slot slot) noexcept {
  const MeshTreeNode& node = tree.nodes()[slot >> kSlotBits];
  const std::uint32_t at = slot & (MeshTreeNode::kWidth - 1);
  return node.half[0][at] + node.half[1][at] + node.half[2][at];
}

// Chooses the side to open. Of the other side only a triangle is placed.
void chooseSide(const MeshPair& pair, Slot a, Slot b, OpenedPair& opened) noexcept {
  const std::uint32_t child_a = childOf(pair.a, a);
  const std::uint32_t child_b = childOf(pair.b, b);
  opened.is_of_a =
      isTriangle(child_b) || (!isTriangle(child_a) && sizeOf(pair.a, a) > sizeOf(pair.b, b));
  const MeshTree& opened_tree = opened.is_of_a ? pair.a : pair.b;
  const MeshTree& other_tree = opened.is_of_a ? pair.b : pair.a;
  const std::uint32_t node = opened.is_of_a ? child_a : child_b;
  const std::uint32_t other = opened.is_of_a ? child_b : child_a;
  opened.first = node << kSlotBits;
  opened.other = opened.is_of_a ? b : a;
  opened.node = &opened_tree.nodes()[node];
  opened.triangle.reset();
  if (isTriangle(other)) {
    opened.triangle = place(opened.is_of_a ? pair.bounds_to_a : pair.bounds_to_b,
                            other_tree.center(), other_tree.triangles()[triangleAt(other)]);
  }
}

// Places the bound of the other side.
void placeBound(const MeshPair& pair, OpenedPair& opened) noexcept {
  opened.placed = opened.is_of_a ? place(pair.bounds_to_a, boundAt(pair.b, opened.other))
                                 : place(pair.bounds_to_b, boundAt(pair.a, opened.other));
}

}  // namespace

MeshPair makeMeshPair(const PlacedMesh& a, const PlacedMesh& b) noexcept {
  const Pose a_from_b = inverse(a.world_from_mesh) * b.world_from_mesh;
  // Bounds are relative to the centers of their trees.
  const Pose centered{a_from_b.rotation, a_from_b * b.tree.center() - a.tree.center()};
  const double size = a.tree.radius() + b.tree.radius() + centered.translation.norm();
  return {a.tree,
          b.tree,
          a_from_b,
          makePlacement(centered, size),
          makePlacement(inverse(centered), size),
          kTouchingShare * (size + a.tree.center().norm() + b.tree.center().norm())};
}

Triangle triangleOfB(const MeshPair& pair, std::uint32_t triangle) noexcept {
  const Triangle& in_b = pair.b.triangles()[triangle];
  return {pair.a_from_b * in_b[0], pair.a_from_b * in_b[1], pair.a_from_b * in_b[2]};
}

double squaredGapAlong(const Eigen::Vector3d& direction, const MeshPair& pair,
                       const TrianglePair& triangles) noexcept {
  const Triangle& a = pair.a.triangles()[triangles.a];
  const Triangle& b = pair.b.triangles()[triangles.b];
  const Eigen::Vector3d in_b = pair.a_from_b.rotation.transpose() * direction;
  const double end_of_a = std::max({direction.dot(a[0]), direction.dot(a[1]), direction.dot(a[2])});
  const double start_of_b = std::min({in_b.dot(b[0]), in_b.dot(b[1]), in_b.dot(b[2])});
  const double gap = direction.dot(pair.a_from_b.translation) + start_of_b - end_of_a;
  return gap > 0.0 ? gap * gap / direction.squaredNorm() : 0.0;
}

double NodePairQueue::leastBound(double start) const noexcept {
  for (std::size_t i = 0; i < size_; ++i) {
    start = std::min(start, static_cast<double>(memory_.node_pairs[i].squared_bound));
  }
  return start;
}

void choose(const MeshPair& pair, Slot a, Slot b, OpenedPair& opened) noexcept {
  chooseSide(pair, a, b, opened);
  if (!opened.triangle) {
    placeBound(pair, opened);
  }
}

void boundChildren(float limit, OpenedPair& opened) noexcept {
  opened.nearer = opened.triangle
                      ? boundNearer(*opened.node, *opened.triangle, limit, opened.bounds)
                      : boundNearer(*opened.node, opened.placed, limit, opened.bounds);
}

void openLarger(const MeshPair& pair, const MeshQueryMemory::NodePair& bounds, float limit,
                NodePairQueue& queue) noexcept {
  OpenedPair opened;
  choose(pair, bounds.a, bounds.b, opened);
  boundChildren(limit, opened);
  queue.pushNearer(opened);
}

float asLimit(double squared_distance) noexcept {
  constexpr double kUlp = std::numeric_limits<float>::epsilon();
  constexpr double kWithinReach = 1e30;
  return static_cast<float>(std::min(squared_distance, kWithinReach) * (1.0 + kUlp));
}

}  // namespace collision_monitor
