// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "collision_monitor/broad_phase/box_rows.h"
#include "collision_monitor/geometry/ids.h"

namespace collision_monitor {

/// Two bodies that may touch, a < b.
struct BodyPair {
  BodyId a{};  ///< the body with the lower id
  BodyId b{};  ///< the body with the higher id
};

/// The fixed list of pairs that may touch, in the order given, with a look-up from two bodies to
/// their pair. It is fast if most pairs of a body a follow each other, in order of body b. Built at
/// set-up, read-only after.
class PairTable {
 public:
  PairTable() = default;
  /// @pre a < b < body_count for every pair; no pair appears twice.
  PairTable(std::vector<BodyPair> pairs, std::size_t body_count);

  const std::vector<BodyPair>& pairs() const noexcept { return pairs_; }  ///< all pairs, by PairId
  /// @pre `id` names a pair of this table.
  const BodyPair& operator[](PairId id) const noexcept { return pairs_[index(id)]; }
  std::size_t size() const noexcept { return pairs_.size(); }  ///< how many pairs there are

  /// Finds the pair of two bodies, given in either order.
  /// @return false when they may not touch; `id` then stays unchanged.
  bool find(BodyId one, BodyId other, PairId& id) const noexcept;

  /// The pair of bodies a and b, at a * body_count + b: its id, or kNone if there is no pair or
  /// a > b. kRowPadding times kNone follow the last. Null for more bodies than a robot has.
  const std::uint32_t* idsOfAll() const noexcept { return dense_.empty() ? nullptr : &dense_[0]; }

 private:
  /// Pairs [first, last) of one body a that follow each other, with increasing body b.
  struct Run {
    std::uint32_t first{0};
    std::uint32_t last{0};
  };

  void fillDense();
  void fillRuns();

  std::vector<BodyPair> pairs_;
  std::vector<Run> runs_;  ///< grouped by body a; used without dense_
  /// By body a: where its runs start; one more entry at the end.
  std::vector<std::uint32_t> first_run_;
  std::vector<std::uint32_t> dense_;  ///< see idsOfAll; may be empty
  std::size_t body_count_{0};
};

}  // namespace collision_monitor
