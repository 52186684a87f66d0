// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "narrow_phase/mesh/mesh_bounds.h"
#include "narrow_phase/mesh/mesh_distance.h"
#include "narrow_phase/triangle/triangle_triangle.h"

/// What queries about two meshes share: a stack of node pairs, the nearest on top.
namespace collision_monitor {

/// Share of the sizes and the distance of the centers: surfaces this near touch.
constexpr double kTouchingShare = 1e-14;

/// Names a bound by its node and slot: node * 8 + slot. 0 is the whole mesh.
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
  double rounding;  ///< [m] surfaces this near touch
};

MeshPair makeMeshPair(const PlacedMesh& a, const PlacedMesh& b) noexcept;

/// A triangle of B in the frame of A.
Triangle triangleOfB(const MeshPair& pair, std::uint32_t triangle) noexcept;

/// [m^2] The squared gap of two triangles along a direction of any length from A to B, in the frame
/// of A; 0 if it does not separate them.
double squaredGapAlong(const Eigen::Vector3d& direction, const MeshPair& pair,
                       const TrianglePair& triangles) noexcept;

/// A node pair of which one side is opened: its children beside the other side.
struct OpenedPair {
  const MeshTreeNode* node;                ///< has the children
  PlacedBound placed;                      ///< the other side, in their frame, if it is a bound
  std::optional<PlacedTriangle> triangle;  ///< the same, if it is a triangle of a mesh
  Slot first;                              ///< first of the children
  Slot other;
  bool is_of_a;
  NodeBounds bounds;
  std::uint32_t nearer;  ///< a bit for each child whose squared bound is below the limit

  MeshQueryMemory::NodePair childAt(std::uint32_t slot) const noexcept {
    return is_of_a ? MeshQueryMemory::NodePair{bounds.squared[slot], first + slot, other}
                   : MeshQueryMemory::NodePair{bounds.squared[slot], other, first + slot};
  }
};

/// The node pairs that are still to be looked at.
class NodePairQueue {
 public:
  using NodePair = MeshQueryMemory::NodePair;

  explicit NodePairQueue(MeshQueryMemory& memory) noexcept : memory_(memory) {}

  void clear() noexcept { size_ = 0; }
  bool empty() const noexcept { return size_ == 0; }
  NodePair pop() noexcept { return memory_.node_pairs[--size_]; }
  void push(const NodePair& pair) noexcept { memory_.node_pairs[size_++] = pair; }

  /// Queues the children that have a bit in `nearer`, the first in order on top. `childAt(slot)`
  /// makes a node pair of a child.
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

  /// The least bound in the queue; `start` if none is less.
  double leastBound(double start) const noexcept;

 private:
  MeshQueryMemory& memory_;
  std::size_t size_{0};
};

/// Chooses which side of a node pair to open: always the larger node. Places the other side. Does
/// not bound the children.
/// @pre at least one side is a node.
void choose(const MeshPair& pair, Slot a, Slot b, OpenedPair& opened) noexcept;

/// Bounds the children against the other side: fills `bounds` and `nearer`.
void boundChildren(float limit, OpenedPair& opened) noexcept;

/// Opens one side of a node pair, as choose(). Queues the children whose squared distance to the
/// other side may be below `limit`.
void openLarger(const MeshPair& pair, const MeshQueryMemory::NodePair& bounds, float limit,
                NodePairQueue& queue) noexcept;

/// Makes a squared distance comparable with bounds: rounded up, and less than that of empty slots.
float asLimit(double squared_distance) noexcept;

/// Whether one of two meshes is inside the other.
struct Holding {
  std::optional<Eigen::Vector3d> point;  ///< in both solids, in A's frame
  HeldProbe probe{kNone};                ///< which one it is
  /// [m] If there is none: how far a mesh must travel, at least, as in MeshDistance::outside.
  double outside{std::numeric_limits<double>::infinity()};
  std::uint32_t visits{0};  ///< of open surfaces, converted to nodes
};

/// What is asked of all probes.
struct HoldingQuery {
  bool asks_outside{true};  ///< also finds Holding::outside; else it means nothing
  double apart{0.0};        ///< [m] a lower bound of the distance of the surfaces
  KeptProbes kept{};
};

/// Finds a point of one mesh inside the other. The surfaces must not cross. So a closed mesh holds
/// each piece of the other as a whole or not at all, and one probe a piece is enough. An open mesh
/// is asked for every probe of the other whose kept answer no longer holds.
Holding pointHeld(const MeshPair& pair, MeshQueryMemory& memory,
                  const HoldingQuery& query) noexcept;

/// Asks for one probe alone. @param probe may be none
Holding probeHeld(const MeshPair& pair, HeldProbe probe, MeshQueryMemory& memory) noexcept;

/// [m] Whether something is inside an open mesh is not asked again after less travel than this. The
/// inside ends at the rim only by convention, and a search that comes near must not go on by ever
/// shorter steps.
double leastHold(const MeshTree& open) noexcept;

}  // namespace collision_monitor
