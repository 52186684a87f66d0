// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
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

/// The distance of two elements. Quality::unknown: no more than enclosing shapes say.
struct ElementDistance {
  Quality quality{Quality::unknown};
  bool has_points{false};  ///< false: a lower bound without points
  SignedDistance measured;
  double shortfall{0.0};    ///< [m] as MeshDistance::shortfall
  std::uint32_t work{0};    ///< work done of the budget
  bool is_complete{false};  ///< false: a larger budget would have found more
  /// [m] as MeshDistance::outside
  double outside{std::numeric_limits<double>::infinity()};
};

/// The last measurement of a pair of elements, and the poses it was made at.
struct LastMeasurement {
  ElementDistance found;
  Pose world_from_a;
  Pose world_from_b;
};

/// Foretells the answer of a contact test from the last ones.
///
/// Source: a saturating counter, as it predicts branches of programs (Smith 1981).
class ContactForecast {
 public:
  bool isLikely() const noexcept { return score_ >= kLikely; }
  void add(bool is_contact) noexcept {
    score_ = is_contact ? std::min(score_ + 1, kMost) : std::max(score_ - kLoss, 0);
  }

 private:
  // With these, contact is likely where it is seen more than twice as often as not.
  static constexpr std::int32_t kLikely = 6;
  static constexpr std::int32_t kMost = 8;
  static constexpr std::int32_t kLoss = 2;

  std::int32_t score_{0};
};

/// What is kept of the last measurements of a pair of elements, as a warm start of the next one and
/// as a bound where there is none. Takes some thousand bytes, with meshes over ten thousand.
struct RefineMemory {
  ConvexWarmStart warm;
  TrianglePair nearest;
  LastMeasurement last;
  LastMeasurement before;          ///< the one before `last`, at other poses
  MeshFront* front{nullptr};       ///< where a mesh is searched; null: starts at the roots
  ContactForecast triangles_meet;  ///< that a test of few triangles finds a contact
  KeptDepth* depth{nullptr};  ///< of two elements with meshes, one or both not convex; keptDepth
  FixedRoom<KeptDepth>* depths{nullptr};  ///< room for `depth`, where there is none yet
};

/// What depths of the pair leave for the next ones; null if they leave nothing. It is large and few
/// pairs overlap, so it is made when it is first asked for.
KeptDepth* keptDepth(RefineMemory& memory) noexcept;

/// Keeps a measurement as the last one.
void remember(const LastMeasurement& measurement, RefineMemory& memory) noexcept;

/// Makes the memory as new.
void forget(RefineMemory& memory) noexcept;

/// What a pair of elements keeps, and so what its memory has room for.
enum class RefineKind : unsigned char {
  never,  ///< its bodies are exact: nothing to refine
  plain,
  front,  ///< RefineMemory::front
  depth,  ///< keptDepth
  both,
};

/// The memories of pairs of elements. While few pairs are ever refined each has its own. Of more
/// pairs only those measured last have one, since memory would otherwise grow with the square of
/// links; there are more memories than a cycle's budget measures pairs. Forgetting a pair has the
/// effects that resetMemory has for refinement. Memories are made when they are first asked for, in
/// room that is there: making all at once would take longer than anything else at set-up.
class RefineStore {
 public:
  static constexpr std::size_t kMostPlain = 2048;   ///< memories of kind plain
  static constexpr std::size_t kMostMeshes = 1024;  ///< of each other kind

  /// Blocks of fronts: some for each pair with a front, and some for all. Few pairs are near each
  /// other at a time, and some of these need many.
  static constexpr std::size_t kBlocksOfPair = 2;
  static constexpr std::size_t kBlocksOfAll = 4 * std::size_t{MeshFront::kMostBlocks};

  RefineStore() = default;
  /// @param kinds by ElementPairIndex
  explicit RefineStore(std::vector<RefineKind> kinds);

  /// The memory of a pair; as new if it had none or lost it to another pair. Valid until the memory
  /// of another pair is asked for.
  RefineMemory& of(ElementPairIndex pair) noexcept;

  /// The last measurement of a pair; as new if the pair has no memory.
  const LastMeasurement& lastOf(ElementPairIndex pair) const noexcept {
    return slot_of_[pair] == kNone ? kNothingMeasured : slots_[slot_of_[pair]].memory.last;
  }

  /// The measurement before, at other poses; as new if there is none.
  const LastMeasurement& beforeOf(ElementPairIndex pair) const noexcept {
    return slot_of_[pair] == kNone ? kNothingMeasured : slots_[slot_of_[pair]].memory.before;
  }

  /// The most memories there can be.
  std::size_t size() const noexcept { return slots_.most(); }

  /// Makes all memories as new.
  void forgetAll() noexcept;

 private:
  static const LastMeasurement kNothingMeasured;

  struct Slot {
    RefineMemory memory;
    ElementPairIndex pair{kNone};  ///< the pair that has it
    std::uint32_t older{kNone};    ///< the slot of its kind that was asked for before this one
    std::uint32_t newer{kNone};
  };
  /// The slots of a kind in order of use.
  struct Order {
    std::uint32_t newest{kNone};
    std::uint32_t oldest{kNone};
    std::uint32_t unmade{0};  ///< how many more may be made
  };

  std::uint32_t takeSlot(RefineKind kind) noexcept;
  std::uint32_t makeSlot(RefineKind kind) noexcept;
  void takeOut(Order& order, std::uint32_t slot) noexcept;
  void putFirst(Order& order, std::uint32_t slot) noexcept;

  std::unique_ptr<FrontPool> pool_;
  FixedRoom<MeshFront> fronts_;
  std::unique_ptr<FixedRoom<KeptDepth>> depths_;  ///< memories name it
  FixedRoom<Slot> slots_;
  std::vector<std::uint32_t> slot_of_;  ///< by ElementPairIndex
  std::vector<RefineKind> kinds_;       ///< by ElementPairIndex
  std::array<Order, 5> orders_;         ///< by RefineKind
};

}  // namespace collision_monitor
