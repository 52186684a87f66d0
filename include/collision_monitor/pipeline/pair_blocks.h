// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "collision_monitor/broad_phase/pair_table.h"
#include "collision_monitor/narrow_phase/pair_rows.h"

/// All pairs of a table in one pose, without a broad phase: bodies stand in columns, those of one
/// kind next to each other, and a body is measured against several neighbours at once. Nothing is
/// gathered pair by pair, which would cost more than the measuring.
namespace collision_monitor {

/// Neighbours that a block joins with one body, a multiple of the lanes of every instruction set.
constexpr std::size_t kBlockLanes = 8;

/// Groups of so many slots that so many bodies take.
constexpr std::size_t groupCountOf(std::size_t bodies) noexcept {
  return (bodies + kBlockLanes - 1) / kBlockLanes;
}

/// The body in slot `one` and those from slot `first` on, as far as they are pairs of the table.
struct PairBlock {
  std::uint32_t one{0};
  std::uint32_t first{0};
  std::uint32_t is_pair{0};     ///< bit by lane
  std::uint32_t first_pair{0};  ///< PairId of the lowest bit, from which the others count on
  std::uint32_t arrived{0};     ///< groups of slots that this block and those before it need
};

/// Blocks [first, last) join a body of kind `one` with bodies of kind `row`.
struct BlockRange {
  CoreKind one{};
  CoreKind row{};
  std::size_t first{0};
  std::size_t last{0};
};

/// Made at set-up.
struct PairBlocks {
  std::vector<std::uint32_t> slot_of;  ///< by BodyId: ordered by kind, then by id
  std::vector<PairBlock> blocks;
  std::vector<BlockRange> ranges;
  std::vector<std::uint32_t> arrivals;  ///< groups with pairs, as the blocks come to need them
};

PairBlocks makeBlocks(const PairTable& table, const std::vector<Core>& cores);

/// Columns of all bodies, as those of pair_rows.h, and the radii of their bounding spheres.
struct BodyRows {
  std::size_t stride{0};
  std::vector<double> numbers;  ///< column c of slot s: [c * stride + s]

  double* at(std::size_t c) noexcept { return numbers.data() + c * stride; }
  const double* at(std::size_t c) const noexcept { return numbers.data() + c * stride; }
};

constexpr std::size_t kBoundingColumn = column::count;

/// A pose is this many numbers in a row: the columns of its rotation, then the translation.
constexpr std::size_t kPoseNumbers = sizeof(Pose) / sizeof(double);
static_assert(kPoseNumbers == 12);

/// How the bodies in kBlockLanes slots are fixed to their links, laid out to be placed together.
/// Made at set-up.
struct SlotGroup {
  alignas(64) double link_from_body[kPoseNumbers][kBlockLanes] = {};
  std::int64_t pose_at[kBlockLanes] =
      {};                                ///< where among the numbers of all poses the link's start
  std::uint32_t link[kBlockLanes] = {};  ///< LinkId
  CoreKind kind{CoreKind::point};        ///< of the last of them, the largest
};

/// Sized for the bodies, with what does not move filled in. `bounding_radii` by BodyId.
BodyRows makeBodyRows(const PairBlocks& blocks, const std::vector<Core>& cores,
                      const std::vector<double>& bounding_radii);

inline void writeVector(const Eigen::Vector3d& v, std::size_t c, std::size_t slot,
                        BodyRows& rows) noexcept {
  rows.at(c)[slot] = v.x();
  rows.at(c + 1)[slot] = v.y();
  rows.at(c + 2)[slot] = v.z();
}

/// Of a body's pose, what its kind needs.
inline void writeBody(CoreKind kind, const Pose& world_from_body, std::size_t slot,
                      BodyRows& rows) noexcept {
  writeVector(world_from_body.translation, column::center, slot, rows);
  if (kind != CoreKind::point) {
    writeVector(world_from_body.rotation.col(2), column::axis_z, slot, rows);
  }
  if (kind == CoreKind::box) {
    writeVector(world_from_body.rotation.col(0), column::axis_x, slot, rows);
    writeVector(world_from_body.rotation.col(1), column::axis_y, slot, rows);
  }
}

/// The body is not known.
inline void loseBody(std::size_t slot, BodyRows& rows) noexcept {
  rows.at(column::center)[slot] = std::numeric_limits<double>::quiet_NaN();
}

/// Signed distances of all pairs, by PairId; NaN where a body is not known.
/// Error: as distanceBetween; the same bytes with every instruction set.
/// @pre `distances` has the size of the table.
void measureBlocks(const PairBlocks& blocks, const BodyRows& rows,
                   std::vector<double>& distances) noexcept;

struct NearestPair {
  PairId pair{};
  double distance{std::numeric_limits<double>::infinity()};  ///< [m]
};

/// Pairs that a search passes over: those whose group is marked.
struct PassedPairs {
  const std::vector<std::uint32_t>& group_of;   ///< by PairId
  const std::vector<unsigned char>& is_passed;  ///< by group
};

/// The nearest pair that is not passed over, if it is nearer than `best`. Of equal distances the
/// pair that stands first. Bounding spheres spare most of the measuring.
void searchBlocks(const PairBlocks& blocks, const BodyRows& rows, const PassedPairs& passed,
                  NearestPair& best) noexcept;

/// [m] At or below these distances pairs are in contact.
struct ContactDistances {
  std::vector<double> of_pair;  ///< by PairId
  double largest{-std::numeric_limits<double>::infinity()};
};

struct FoundContact {
  NearestPair contact;      ///< the first in the table; infinitely far if there is none
  bool has_unknown{false};  ///< a pair that was looked at has a body that is not known
};

/// Whether any pair is in contact. Ends at the first block of pairs that has one; bounding spheres
/// spare most of the measuring.
/// @pre the bodies are placed in `rows`.
void findContact(const PairBlocks& blocks, const BodyRows& rows, const ContactDistances& limits,
                 FoundContact& found) noexcept;

}  // namespace collision_monitor
