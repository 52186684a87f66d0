// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "collision_monitor/geometry/ids.h"
#include "collision_monitor/geometry/pose.h"
#include "collision_monitor/narrow_phase/convex_workspace.h"
#include "collision_monitor/narrow_phase/quality.h"
#include "collision_monitor/narrow_phase/signed_distance.h"
#include "collision_monitor/pipeline/element.h"
#include "narrow_phase/mesh/mesh_distance.h"
#include "narrow_phase/mesh_depth/mesh_depth.h"

namespace collision_monitor {

/// What was found of two elements. Quality::unknown: nothing that the enclosing shapes do not say.
struct ElementDistance {
  Quality quality{Quality::unknown};
  bool has_points{false};  ///< false: a lower bound without points
  SignedDistance measured;
  double shortfall{0.0};    ///< [m] as MeshDistance::shortfall
  std::uint32_t work{0};    ///< spent of the budget
  bool is_complete{false};  ///< false: a larger budget would have told more
  /// [m] as MeshDistance::outside
  double outside{std::numeric_limits<double>::infinity()};
};

/// The last measurement of a pair of elements, and where they were.
struct LastMeasurement {
  ElementDistance found;
  Pose world_from_a;
  Pose world_from_b;
};

/// What is left of the last measurement of a pair of elements: where the next one starts, and what
/// still holds where there is none. Some thousand bytes, with meshes more than ten thousand.
struct RefineMemory {
  ConvexWarmStart warm;
  TrianglePair nearest;
  LastMeasurement last;
  LastMeasurement before;            ///< of `last`, where they were elsewhere
  std::unique_ptr<MeshFront> front;  ///< where a mesh is searched; none: from the roots
  std::unique_ptr<KeptDepth> depth;  ///< of two with meshes, of which one is not convex
};

/// Keeps a measurement as the last one.
void remember(const LastMeasurement& measurement, RefineMemory& memory) noexcept;

/// Leaves it as new.
void forget(RefineMemory& memory) noexcept;

/// What measuring a pair of elements leaves behind, which says what its memory has room for.
enum class RefineKind : unsigned char {
  never,  ///< its bodies say all
  plain,
  front,  ///< RefineMemory::front
  depth,  ///< RefineMemory::depth
  both,
};

/// The memories of pairs of elements. Every pair has one of its own as long as few pairs are
/// refined at all; of more pairs those have one that were measured last, for memory would else grow
/// with the square of links. There are more of them than a cycle's budget measures pairs.
/// What a pair has forgotten costs time, as resetMemory does.
class RefineStore {
 public:
  static constexpr std::size_t kMostPlain = 2048;  ///< memories of pairs without meshes
  static constexpr std::size_t kMostMeshes = 640;  ///< of each other kind

  /// Blocks of fronts for each pair that has one, and for all together: few pairs are near each
  /// other at a time, and of these some need many.
  static constexpr std::size_t kBlocksOfPair = 2;
  static constexpr std::size_t kBlocksOfAll = 4 * std::size_t{MeshFront::kMostBlocks};

  RefineStore() = default;
  /// @param kinds by ElementPairIndex
  explicit RefineStore(std::vector<RefineKind> kinds);

  /// The memory of a pair; as new if it had none, or has lost it to another.
  /// It stays the pair's until memories of other pairs are asked for.
  RefineMemory& of(ElementPairIndex pair) noexcept;

  /// What is left of the last measurement; as new if the pair has no memory.
  const LastMeasurement& lastOf(ElementPairIndex pair) const noexcept {
    return slot_of_[pair] == kNone ? kNothingMeasured : slots_[slot_of_[pair]].memory.last;
  }

  /// The one before that, at other poses; as new if there is none.
  const LastMeasurement& beforeOf(ElementPairIndex pair) const noexcept {
    return slot_of_[pair] == kNone ? kNothingMeasured : slots_[slot_of_[pair]].memory.before;
  }

  /// How many memories there are.
  std::size_t size() const noexcept { return slots_.size(); }

  /// Leaves all as new.
  void forgetAll() noexcept;

 private:
  static const LastMeasurement kNothingMeasured;

  struct Slot {
    RefineMemory memory;
    ElementPairIndex pair{kNone};  ///< whose it is
    std::uint32_t older{kNone};    ///< of its kind: asked for before this one
    std::uint32_t newer{kNone};
  };
  /// In order of when they were asked for.
  struct Order {
    std::uint32_t newest{kNone};
    std::uint32_t oldest{kNone};
  };

  void addSlots(RefineKind kind, std::size_t count);
  void takeOut(Order& order, std::uint32_t slot) noexcept;
  void putFirst(Order& order, std::uint32_t slot) noexcept;

  std::unique_ptr<FrontPool> pool_;
  std::vector<Slot> slots_;
  std::vector<std::uint32_t> slot_of_;  ///< by ElementPairIndex
  std::vector<RefineKind> kinds_;       ///< by ElementPairIndex
  std::array<Order, 5> orders_;         ///< by RefineKind
};

}  // namespace collision_monitor
