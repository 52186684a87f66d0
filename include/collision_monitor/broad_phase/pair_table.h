// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "collision_monitor/geometry/ids.h"

namespace collision_monitor {

struct BodyPair {
  BodyId a{};
  BodyId b{};
};

/// The fixed list of pairs that may touch, and the way back from two bodies to
/// their pair. Built at set-up, read-only after.
class PairTable {
 public:
  PairTable() = default;
  /// @pre bodies are below `body_count`; no pair stands twice, in either order.
  PairTable(std::vector<BodyPair> pairs, std::size_t body_count);

  const std::vector<BodyPair>& pairs() const noexcept { return pairs_; }
  const BodyPair& operator[](PairId id) const noexcept { return pairs_[index(id)]; }
  std::size_t size() const noexcept { return pairs_.size(); }
  std::size_t bodyCount() const noexcept { return body_count_; }

  /// The pair of two bodies in either order.
  /// @return false when they may not touch; `id` is then left alone.
  bool find(BodyId a, BodyId b, PairId& id) const noexcept;

 private:
  std::vector<BodyPair> pairs_;
  std::unordered_map<std::uint64_t, PairId> ids_;
  std::size_t body_count_{0};
};

}  // namespace collision_monitor
