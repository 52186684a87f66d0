// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "collision_monitor/broad_phase/pair_table.h"
#include "collision_monitor/narrow_phase/pair_rows.h"

/// Measures all pairs of a table in one pose, without a broad phase. Bodies stand in columns,
/// grouped by kind. One body is measured against several neighbours at once: gathering single pairs
/// would cost more than measuring them.
namespace collision_monitor {

/// How many neighbours a block joins with one body: a multiple of the lanes of all targets.
constexpr std::size_t kBlockLanes = 8;

/// How many groups of kBlockLanes slots hold this many bodies.
constexpr std::size_t groupCountOf(std::size_t bodies) noexcept {
  return (bodies + kBlockLanes - 1) / kBlockLanes;
}

/// Joins the body in slot `one` with the bodies in slots from `first` on that form pairs with it.
struct PairBlock {
  std::uint32_t one{0};      ///< slot of the body
  std::uint32_t first{0};    ///< slot of the first neighbour; kBlockLanes slots follow each other
  std::uint32_t is_pair{0};  ///< bit by lane
  std::uint32_t first_pair{0};  ///< PairId of the lowest set bit; the other pairs follow in order
};

/// Blocks [first, last) join a body of kind `one` with bodies of kind `row`.
struct BlockRange {
  CoreKind one{};        ///< of the single bodies
  CoreKind row{};        ///< of their neighbours
  std::size_t first{0};  ///< index into PairBlocks::blocks
  std::size_t last{0};   ///< index behind the last one
};

/// How bodies and pairs are laid out. Made at set-up.
struct PairBlocks {
  std::vector<std::uint32_t> slot_of;  ///< by BodyId: ordered by kind, then by id
  std::vector<PairBlock> blocks;       ///< grouped by kinds
  std::vector<BlockRange> ranges;      ///< one for each two kinds that form pairs
};

/// Lays out the pairs of a table. @param cores by BodyId.
PairBlocks makeBlocks(const PairTable& table, const std::vector<Core>& cores);

/// Columns of all bodies, as in pair_rows.h, and the radii of their bounding spheres.
struct BodyRows {
  std::size_t stride{0};        ///< slots of a column, with those that fill up the last vector
  std::vector<double> numbers;  ///< column c of slot s: [c * stride + s]

  /// Column c, by slot.
  double* at(std::size_t c) noexcept { return numbers.data() + c * stride; }
  /// Column c, by slot.
  const double* at(std::size_t c) const noexcept { return numbers.data() + c * stride; }
};

/// The column of BodyRows with the radii of bounding spheres, behind those of a posed shape.
constexpr std::size_t kBoundingColumn = column::count;

/// Sizes the columns and fills in what does not move. `bounding_radii` is by BodyId.
BodyRows makeBodyRows(const PairBlocks& blocks, const std::vector<Core>& cores,
                      const std::vector<double>& bounding_radii);

/// Writes x, y and z of a slot into the columns c, c + 1 and c + 2.
inline void writeVector(const Eigen::Vector3d& v, std::size_t c, std::size_t slot,
                        BodyRows& rows) noexcept {
  rows.at(c)[slot] = v.x();
  rows.at(c + 1)[slot] = v.y();
  rows.at(c + 2)[slot] = v.z();
}

/// Writes the columns that the kind needs.
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

/// Marks the body as not known.
inline void loseBody(std::size_t slot, BodyRows& rows) noexcept {
  rows.at(column::center)[slot] = std::numeric_limits<double>::quiet_NaN();
}

/// A pair and its distance.
struct NearestPair {
  PairId pair{};  ///< no pair while the distance is infinite
  double distance{std::numeric_limits<double>::infinity()};  ///< [m]
};

/// Lists the pairs that are at most `within` [m] apart, with their signed distances, by PairId.
/// Leaves out pairs with a body that is not known. Bounding spheres save most of the measuring.
/// Error: as distanceBetween; the same bytes with every instruction set.
/// @param near is overwritten. @pre it has room for all pairs.
void findNear(const PairBlocks& blocks, const BodyRows& rows, double within,
              std::vector<NearestPair>& near) noexcept;

/// Pairs that a search skips: those of a marked group.
struct PassedPairs {
  const std::vector<std::uint32_t>& group_of;   ///< by PairId
  const std::vector<unsigned char>& is_passed;  ///< by group
};

/// Finds the nearest pair that is not skipped, if it is nearer than `best`. Of equal distances the
/// first pair of the table wins. Bounding spheres save most of the measuring.
void searchBlocks(const PairBlocks& blocks, const BodyRows& rows, const PassedPairs& passed,
                  NearestPair& best) noexcept;

/// [m] Pairs are in contact at or below these distances.
struct ContactDistances {
  std::vector<double> of_pair;                               ///< by PairId
  double largest{-std::numeric_limits<double>::infinity()};  ///< [m] of all pairs
};

/// What a search for a contact found.
struct FoundContact {
  NearestPair contact;      ///< the first in the table; infinitely far if there is none
  bool has_unknown{false};  ///< a visited pair has a body that is not known
};

/// Finds whether any pair is in contact. Ends at the first block that has a contact. Bounding
/// spheres save most of the measuring.
/// @pre the bodies are placed in `rows`.
void findContact(const PairBlocks& blocks, const BodyRows& rows, const ContactDistances& limits,
                 FoundContact& found) noexcept;

}  // namespace collision_monitor
