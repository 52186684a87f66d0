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
#include "geometry/fixed_room.h"
#include "narrow_phase/mesh_inside/kept_probe.h"

/// What a search of a mesh and something else leaves for the next one about the same two. Units:
/// metres.
namespace collision_monitor {

class FrontPool;

/// A front of pairs, of bounds or triangles, beyond which a search did not look.
///
/// Each pair has a lower bound of its distance, which every step of the motion loosens. It is not
/// looked at until its bound is below the nearest distance. A pair separated along a direction
/// loses only its motion along that direction, and what the ball about its moving side turns:
/// nearly nothing where surfaces slide past each other. Children of one bound stay one entry as
/// long as none is looked at. If there is no room for all pairs, `cover` stands for the farthest;
/// once it is used up, the search starts from the roots.
/// Source: Verlet, "Computer 'experiments' on classical fluids I" (1967), for the motion; Ehmann,
/// Lin, "Accurate and Fast Proximity Queries Between Polyhedra Using Convex Surface Decomposition"
/// (2001), for the front of the tree of pairs, which is kept here with bounds.
struct MeshFront {
  static constexpr std::uint32_t kBlockSize = 512;
  static constexpr std::uint32_t kMostBlocks = 32;
  static constexpr std::uint32_t kCapacity = kMostBlocks * kBlockSize;

  /// Two bounds or triangles, as MeshQueryMemory::NodePair.
  struct Kept {
    std::uint32_t a;
    std::uint32_t b;
  };

  /// Pairs in columns.
  struct alignas(64) Block {
    std::array<float, kBlockSize> bound;  ///< [m] lower bound of the distance
    /// Direction along which the bound separates the pair, as `packed`; 0: none.
    std::array<std::uint32_t, kBlockSize> direction;
    /// Center of the ball about the moving side, as `packed`, in 1/511 of the mesh's radius.
    std::array<std::uint32_t, kBlockSize> center;
    /// Its radius, 24 bits in 1/2048 of that unit; then a bit for each child of a bound that is
    /// meant; no bit: all.
    std::array<std::uint32_t, kBlockSize> extent;
    std::array<Kept, kBlockSize> kept;
  };

  explicit MeshFront(FrontPool& its_pool, KeptProbes its_probes = {}) noexcept
      : pool(its_pool), probes(its_probes) {}
  MeshFront(const MeshFront&) = delete;
  MeshFront& operator=(const MeshFront&) = delete;
  ~MeshFront() = default;

  FrontPool& pool;
  std::optional<Pose> resting_from_moving;  ///< of the last query, if there was one
  Kept nearest{kNone, kNone};               ///< the nearest triangles of the last query
  double cover{0.0};                        ///< [m] what is not kept is no nearer
  double margin{0.0};           ///< [m] triangles are measured this far beyond the nearest
  double apart{0.0};            ///< [m] between the surfaces; 0 if one was inside the other
  double outside{0.0};          ///< [m] as MeshDistance::outside
  KeptProbes probes;            ///< of two meshes; whoever makes the front has their room
  std::uint32_t from_roots{0};  ///< visits of the search from the roots
  bool is_whole{false};         ///< that search was complete
  std::uint32_t size{0};        ///< number of pairs
  std::uint32_t block_count{0};
  std::array<Block*, kMostBlocks> blocks{};
  std::uint64_t followed_at{0};  ///< FrontPool::clock_ at the last query
  MeshFront* older{nullptr};     ///< in the list of fronts with blocks: queried before this one
  MeshFront* newer{nullptr};
};

/// Blocks for many fronts. A front that was not queried for a while gives its blocks to the others.
/// The pool and its fronts must end together: a front that is gone would stay in the list. Not for
/// two threads at a time.
class FrontPool {
 public:
  explicit FrontPool(std::size_t blocks);

  /// Gives a front one more block.
  /// @return false if it has all that it may have, or none is left.
  bool grow(MeshFront& front) noexcept;

  /// Takes back all blocks of a front and what is kept in them.
  void clear(MeshFront& front) noexcept;

  /// Notes that a front is queried now.
  void touch(MeshFront& front) noexcept;

 private:
  bool isEmpty() const noexcept;
  MeshFront::Block* take() noexcept;
  void takeOut(MeshFront& front) noexcept;
  void putNewest(MeshFront& front) noexcept;

  FixedRoom<MeshFront::Block> blocks_;
  std::vector<MeshFront::Block*> free_;
  MeshFront* oldest_{nullptr};
  MeshFront* newest_{nullptr};
  std::uint64_t clock_{0};
};

}  // namespace collision_monitor
