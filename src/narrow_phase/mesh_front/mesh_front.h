// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "collision_monitor/geometry/ids.h"
#include "collision_monitor/geometry/pose.h"

/// What a search of a mesh and something else leaves for the next one about the same two.
/// Units: metres.
namespace collision_monitor {

class FrontPool;

/// A front of pairs, of bounds or triangles, beyond which a search did not look.
///
/// Each pair has a lower bound of its distance, which every step of the motion loosens, and is not
/// looked at until that is less than the nearest distance. A pair that was last apart along a
/// direction loses how far the step moves it along that direction, and how far the points of the
/// ball about the moving one turn: nearly nothing where surfaces slide past each other. Children of
/// one bound are kept as one as long as none of them is looked at. Where there is no room for all,
/// `cover` stands for those that are farthest; when that is used up the search starts from the
/// roots. Source: Verlet, "Computer 'experiments' on classical fluids I" (1967), for the motion;
/// Ehmann, Lin, "Accurate and Fast Proximity Queries Between Polyhedra Using Convex Surface
/// Decomposition" (2001), for the front of the tree of pairs, which is kept here with bounds.
struct MeshFront {
  static constexpr std::uint32_t kBlockSize = 512;
  static constexpr std::uint32_t kMostBlocks = 32;
  static constexpr std::uint32_t kCapacity = kMostBlocks * kBlockSize;

  /// Two bounds or triangles, as MeshQueryMemory::Waiting.
  struct Kept {
    std::uint32_t a;
    std::uint32_t b;
  };

  /// Pairs, part by part.
  struct alignas(64) Block {
    std::array<float, kBlockSize> bound;  ///< [m] the pair is no nearer
    /// Along which the pair is as far apart as its bound says: as `packed`; 0: along any.
    std::array<std::uint32_t, kBlockSize> direction;
    /// Of the ball about the one that moves, as `packed`, in units of 1/511 of the mesh's radius.
    std::array<std::uint32_t, kBlockSize> center;
    /// Its radius, 24 bits in 1/2048 of that unit; then a bit for each child of a bound that is
    /// meant; none: all are.
    std::array<std::uint32_t, kBlockSize> extent;
    std::array<Kept, kBlockSize> kept;
  };

  explicit MeshFront(FrontPool& its_pool) noexcept : pool(its_pool) {}
  MeshFront(const MeshFront&) = delete;
  MeshFront& operator=(const MeshFront&) = delete;
  ~MeshFront() = default;

  FrontPool& pool;
  std::optional<Pose> resting_from_moving;  ///< of the last query; none: there was none
  Kept nearest{kNone, kNone};               ///< the nearest triangles then
  double cover{0.0};                        ///< [m] what is not kept is no nearer
  double margin{0.0};           ///< [m] how much farther than the nearest triangles are measured
  double apart{0.0};            ///< [m] the surfaces were, and neither inside the other
  double outside{0.0};          ///< [m] as MeshDistance::outside
  std::uint32_t from_roots{0};  ///< visits until the search from the roots was complete
  bool is_whole{false};         ///< it was complete
  std::uint32_t size{0};        ///< pairs
  std::uint32_t block_count{0};
  std::array<Block*, kMostBlocks> blocks{};
  std::uint64_t followed_at{0};  ///< FrontPool::clock of the last query
  MeshFront* older{nullptr};     ///< of those that have blocks: queried before this one
  MeshFront* newer{nullptr};
};

/// Room for many fronts, in blocks that go to those that need them. What no query has asked for a
/// while gives its blocks to the others. It and its fronts end together: a front that is gone would
/// stay in its list. Not for two threads at a time.
class FrontPool {
 public:
  explicit FrontPool(std::size_t blocks);

  /// Gives a front one more block. @return false where it has all that it may have, or none is
  /// left.
  bool grow(MeshFront& front) noexcept;

  /// Takes all blocks and what is kept in them.
  void clear(MeshFront& front) noexcept;

  /// Tells that a front is asked now.
  void touch(MeshFront& front) noexcept;

 private:
  void takeOut(MeshFront& front) noexcept;
  void putNewest(MeshFront& front) noexcept;

  std::vector<MeshFront::Block> blocks_;
  std::vector<MeshFront::Block*> free_;
  MeshFront* oldest_{nullptr};
  MeshFront* newest_{nullptr};
  std::uint64_t clock_{0};
};

}  // namespace collision_monitor
