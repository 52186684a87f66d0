// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "narrow_phase/mesh/mesh_bounds.h"
#include "narrow_phase/mesh/mesh_distance.h"
#include "narrow_phase/triangle/triangle_triangle.h"

/// What the queries about two meshes share: pairs of bounds on a stack, the nearest on top.
namespace collision_monitor {

/// Of the sizes and the way between: surfaces this near are touching.
constexpr double kTouchingShare = 1e-14;

/// A bound is named by its node and slot: node * 8 + slot. 0 is the whole mesh.
using Slot = std::uint32_t;

constexpr std::uint32_t kSlotBits = 3;
static_assert(1U << kSlotBits == MeshTreeNode::kWidth);

inline std::uint32_t childOf(const MeshTree& tree, Slot slot) noexcept {
  return tree.nodes()[slot >> kSlotBits].child[slot & (MeshTreeNode::kWidth - 1)];
}

inline bool isTriangle(std::uint32_t child) noexcept {
  return (child & MeshTreeNode::kTriangle) != 0;
}

inline std::uint32_t triangleAt(std::uint32_t child) noexcept {
  return child & ~MeshTreeNode::kTriangle;
}

inline Bound boundAt(const MeshTree& tree, Slot slot) noexcept {
  return boundOf(tree.nodes()[slot >> kSlotBits], slot & (MeshTreeNode::kWidth - 1));
}

/// Two meshes, seen from A.
struct MeshPair {
  const MeshTree& a;
  const MeshTree& b;
  Pose a_from_b;
  BoundPlacement bounds_to_a;  ///< from B's nodes to A's
  BoundPlacement bounds_to_b;
  double rounding;  ///< [m] surfaces this near are touching
};

MeshPair makeMeshPair(const PlacedMesh& a, const PlacedMesh& b) noexcept;

/// A triangle of B in the frame of A.
Triangle triangleOfB(const MeshPair& pair, std::uint32_t triangle) noexcept;

/// One of two bounds, opened: its children beside the other.
struct OpenedPair {
  const MeshTreeNode* node;  ///< with the children
  PlacedBound placed;        ///< the other, in their frame
  Slot first;                ///< of the children
  Slot other;
  bool is_of_a;
  NodeBounds bounds;
  std::uint32_t nearer;  ///< a bit for each child whose squared bound is below the limit

  MeshQueryMemory::NodePair childAt(std::uint32_t slot) const noexcept {
    return is_of_a ? MeshQueryMemory::NodePair{bounds.squared[slot], first + slot, other}
                   : MeshQueryMemory::NodePair{bounds.squared[slot], other, first + slot};
  }
};

/// The pairs that wait to be looked at.
class NodePairQueue {
 public:
  using NodePair = MeshQueryMemory::NodePair;

  explicit NodePairQueue(MeshQueryMemory& memory) noexcept : memory_(memory) {}

  void clear() noexcept { size_ = 0; }
  bool empty() const noexcept { return size_ == 0; }
  NodePair pop() noexcept { return memory_.node_pairs[--size_]; }
  void push(const NodePair& pair) noexcept { memory_.node_pairs[size_++] = pair; }

  /// Adds the children that `nearer` has a bit for, the first in order last. `childAt(slot)` makes
  /// a pair of one.
  template <class ChildAt>
  void pushNearer(const NodeBounds& bounds, std::uint32_t nearer, const ChildAt& childAt) noexcept {
    const std::size_t bottom = size_;
    std::array<float, MeshTreeNode::kWidth> orders;
    for (; nearer != 0; nearer &= nearer - 1) {
      const auto slot = static_cast<std::uint32_t>(__builtin_ctz(nearer));
      const float order = bounds.order[slot];
      std::size_t place = size_++;
      for (; place > bottom && orders[place - 1 - bottom] < order; --place) {
        memory_.node_pairs[place] = memory_.node_pairs[place - 1];
        orders[place - bottom] = orders[place - bottom - 1];
      }
      orders[place - bottom] = order;
      memory_.node_pairs[place] = childAt(slot);
    }
  }
  void pushNearer(const OpenedPair& opened) noexcept {
    pushNearer(opened.bounds, opened.nearer,
               [&](std::uint32_t slot) { return opened.childAt(slot); });
  }

  /// The least bound that waits; `start` if none is less.
  double leastBound(double start) const noexcept;

 private:
  MeshQueryMemory& memory_;
  std::size_t size_{0};
};

/// Finds which of two bounds to open, of which at least one is a node: the larger, always the same
/// one. Its children are not bounded yet.
void choose(const MeshPair& pair, Slot a, Slot b, OpenedPair& opened) noexcept;

/// Bounds the children.
void boundChildren(float limit, OpenedPair& opened) noexcept;

/// Opens the larger of two bounds, of which at least one is a node, and lets its children wait
/// whose squared distance to the other bound may be below `limit`.
void openLarger(const MeshPair& pair, const MeshQueryMemory::NodePair& bounds, float limit,
                NodePairQueue& queue) noexcept;

/// Squares of distances as bounds are compared with them: rounded up, and below what empty slots
/// are away.
float asLimit(double squared_distance) noexcept;

/// Whether one of two meshes is inside the other.
struct Holding {
  std::optional<Eigen::Vector3d> point;  ///< that both solids share, in A's frame
  /// [m] Where there is none: how far one may go, seen from the other, until there can be one
  /// though the surfaces have not met.
  double outside{std::numeric_limits<double>::infinity()};
  std::uint32_t visits{0};  ///< of open surfaces, in the time of nodes
};

/// Meant for surfaces that do not cross. Each piece of one is then held by a closed one as a whole
/// or not at all; an open one is asked for all probes of the other.
/// @param asks_outside Holding::outside is wanted, too: else it means nothing.
Holding pointHeld(const MeshPair& pair, MeshQueryMemory& memory, bool asks_outside = true) noexcept;

/// [m] Whether something is inside an open mesh is not asked again for ways shorter than that. The
/// inside does not end at the rim by more than a convention, and a search that comes near shall not
/// go on by steps that get ever shorter.
double leastHold(const MeshTree& open) noexcept;

}  // namespace collision_monitor
