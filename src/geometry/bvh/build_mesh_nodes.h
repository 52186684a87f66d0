// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "collision_monitor/geometry/mesh_tree.h"
#include "geometry/bvh/split_triangles.h"

/// Groups triangles to the nodes of a MeshTree.
namespace collision_monitor {

/// The triangles of a slot, in the order of the tree.
struct SlotExtent {
  std::uint32_t first{0};
  std::uint32_t count{0};  ///< 0: the slot is empty
};

/// Nodes depth-first, so children stand behind their parents, and the triangles of their slots.
struct MeshNodes {
  std::vector<MeshTreeNode> nodes;
  std::vector<std::array<SlotExtent, MeshTreeNode::kWidth>> extents;  ///< by node
};

/// Reorders the items and builds nodes with boxes. Slabs follow once the order is final. Many items
/// take all cores; the result is the same on any number of them.
/// @param size [m] bounds every coordinate
/// @throws Interrupted
MeshNodes buildMeshNodes(double size, std::vector<SplitItem>& items);

}  // namespace collision_monitor
