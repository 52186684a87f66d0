// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/mesh_depth/mesh_support.h"

#include <algorithm>
#include <array>

#include "collision_monitor/geometry/ids.h"
#include "narrow_phase/mesh/mesh_search.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

// Height of the box in the slot: no corner below the slot is higher.
double heightOf(const Bound& bound, const Vector3d& direction) noexcept {
  return direction.dot(bound.center.cast<double>()) +
         direction.cwiseAbs().dot(bound.half.cast<double>());
}

}  // namespace

Vector3d farthestAlong(const PlacedMesh& mesh, const Vector3d& direction) noexcept {
  const MeshTree& tree = mesh.tree;
  const Vector3d in_mesh = mesh.world_from_mesh.rotation.transpose() * direction;
  const double base = in_mesh.dot(tree.center());
  double highest = -std::numeric_limits<double>::infinity();
  Vector3d farthest = tree.center();
  std::array<Slot, MeshQueryMemory::kCapacity> queue;
  std::size_t size = 0;
  queue[size++] = 0;
  while (size > 0) {
    const Slot slot = queue[--size];
    if (heightOf(boundAt(tree, slot), in_mesh) + base <= highest) {
      continue;
    }
    const std::uint32_t child = childOf(tree, slot);
    if (isTriangle(child)) {
      for (const Vector3d& corner : tree.triangles()[triangleAt(child)]) {
        if (in_mesh.dot(corner) > highest) {
          highest = in_mesh.dot(corner);
          farthest = corner;
        }
      }
      continue;
    }
    for (std::uint32_t i = 0; i < MeshTreeNode::kWidth; ++i) {
      if (tree.nodes()[child].child[i] != kNone) {
        queue[size++] = (child << kSlotBits) + i;
      }
    }
  }
  return mesh.world_from_mesh * farthest;
}

}  // namespace collision_monitor
