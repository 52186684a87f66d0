// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "collision_monitor/geometry/ids.h"
#include "geometry/fixed_room.h"
#include "pipeline/data/refine_memory.h"

namespace collision_monitor {

/// Memories for pairs of elements. Each pair has its own, if they are few. Else only the pairs
/// measured last have one, so that the room does not grow with the square of the links; more pairs
/// have one than the budget of a cycle can measure. A memory is made when it is first asked for, in
/// room that exists: to make all at once would take longer than anything else at set-up.
class RefineRoom {
 public:
  static constexpr std::size_t kKinds = 5;
  static constexpr std::size_t kMostPlain = 2048;   ///< memories of kind plain
  static constexpr std::size_t kMostMeshes = 1024;  ///< of each other kind
  static constexpr std::size_t kMostProbes = 512;   ///< kept of a pair

  /// Blocks of fronts: some for each pair with a front, and some for all. Few pairs are near each
  /// other at a time, and some of these need many.
  static constexpr std::size_t kBlocksOfPair = 2;
  static constexpr std::size_t kBlocksOfAll = 4 * std::size_t{MeshFront::kMostBlocks};

  struct Slot {
    RefineMemory memory;
    ElementPairIndex pair{kNone};  ///< the pair that has it
    std::uint32_t older{kNone};    ///< the slot of its kind that was asked for before this one
    std::uint32_t newer{kNone};
  };

  RefineRoom() = default;
  /// @param counts by RefineKind: pairs
  /// @param probes kept of each pair of kind `both`, at most kMostProbes
  RefineRoom(std::array<std::size_t, kKinds> counts, std::size_t probes);

  /// A slot for another pair: a new one, or the one that was asked for longest ago, with its memory
  /// emptied. Slot::pair still names its former pair. @pre there is a pair of this kind
  std::uint32_t take(RefineKind kind) noexcept;
  /// Notes that a slot is asked for now.
  void use(RefineKind kind, std::uint32_t slot) noexcept;

  FixedRoom<Slot>& slots() noexcept { return slots_; }
  const FixedRoom<Slot>& slots() const noexcept { return slots_; }

 private:
  /// The slots of a kind in order of use.
  struct Order {
    std::uint32_t newest{kNone};
    std::uint32_t oldest{kNone};
    std::uint32_t unmade{0};  ///< how many more may be made
  };

  Order& orderOf(RefineKind kind) noexcept { return orders_[static_cast<std::size_t>(kind)]; }
  std::uint32_t makeSlot(RefineKind kind) noexcept;
  KeptProbes makeProbes() noexcept;
  void takeOut(Order& order, std::uint32_t slot) noexcept;
  void putFirst(Order& order, std::uint32_t slot) noexcept;

  std::unique_ptr<FrontPool> pool_;
  FixedRoom<MeshFront> fronts_;
  FixedRoom<KeptProbe> probes_;  ///< fronts name them
  std::size_t probes_of_front_{0};
  std::unique_ptr<FixedRoom<KeptDepth>> depths_;  ///< memories name it
  FixedRoom<Slot> slots_;
  std::array<Order, kKinds> orders_;  ///< by RefineKind
};

/// The memories of all pairs of elements. Forgetting a pair has the effects that resetMemory has
/// for refinement. Pairs of robots and pairs of objects have rooms of their own, so that the former
/// outlive a change of objects.
class RefineStore {
 public:
  RefineStore() = default;
  /// @param kinds by ElementPairIndex
  /// @param probes the most that two meshes have; of more than kMostProbes none is kept
  /// @param is_of_object by ElementPairIndex, whether the pair is of an object; empty: none is
  explicit RefineStore(std::vector<RefineKind> kinds, std::size_t probes = 0,
                       std::vector<unsigned char> is_of_object = {});

  /// The memory of a pair; empty if it had none or lost it to another pair. Valid until the memory
  /// of another pair is asked for.
  RefineMemory& of(ElementPairIndex pair) noexcept;

  /// The last measurement of a pair; empty if the pair has no memory.
  const LastMeasurement& lastOf(ElementPairIndex pair) const noexcept {
    return slot_of_[pair] == kNone ? kNothingMeasured : memoryOf(pair).last;
  }

  /// The measurement before, at other poses; empty if there is none.
  const LastMeasurement& beforeOf(ElementPairIndex pair) const noexcept {
    return slot_of_[pair] == kNone ? kNothingMeasured : memoryOf(pair).before;
  }

  bool isOfObject(ElementPairIndex pair) const noexcept {
    return !is_of_object_.empty() && is_of_object_[pair] != 0;
  }

  /// Empties all memories.
  void forgetAll() noexcept;

  /// Takes the memories of the pairs of robots from the store of another set-up, which keeps none.
  /// @param new_of by former ElementPairIndex. @pre the same pairs of robots, of the same elements
  void takeRobots(RefineStore& former, const std::vector<ElementPairIndex>& new_of) noexcept;

 private:
  static const LastMeasurement kNothingMeasured;

  std::size_t roomOf(ElementPairIndex pair) const noexcept { return isOfObject(pair) ? 1 : 0; }
  /// @pre the pair has one
  const RefineMemory& memoryOf(ElementPairIndex pair) const noexcept {
    return rooms_[roomOf(pair)].slots()[slot_of_[pair]].memory;
  }

  std::array<RefineRoom, 2> rooms_;          ///< of robots, of objects
  std::vector<std::uint32_t> slot_of_;       ///< by ElementPairIndex
  std::vector<RefineKind> kinds_;            ///< by ElementPairIndex
  std::vector<unsigned char> is_of_object_;  ///< by ElementPairIndex, or empty
};

}  // namespace collision_monitor
