// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/broad_phase/pair_table.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

#include "collision_monitor/geometry/ids.h"

namespace collision_monitor {
namespace {

constexpr std::size_t kMostDenseBodies = 1000;

}  // namespace

PairTable::PairTable(std::vector<BodyPair> pairs, std::size_t body_count)
    : pairs_(std::move(pairs)), body_count_(body_count) {
  if (body_count <= kMostDenseBodies) {
    fillDense();
  } else {
    fillPartners();
  }
}

void PairTable::fillDense() {
  dense_.resize(body_count_ * body_count_ + kRowPadding, kNone);
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    assert(pairs_[i].a < pairs_[i].b && index(pairs_[i].b) < body_count_);
    dense_[index(pairs_[i].a) * body_count_ + index(pairs_[i].b)] = static_cast<std::uint32_t>(i);
  }
}

void PairTable::fillPartners() {
  first_partner_.resize(body_count_ + 1, 0);
  for (const BodyPair& pair : pairs_) {
    assert(pair.a < pair.b && index(pair.b) < body_count_);
    ++first_partner_[index(pair.a) + 1];
  }
  std::partial_sum(first_partner_.begin(), first_partner_.end(), first_partner_.begin());
  // Sorted by body b first, each body a gets its partners in order.
  std::vector<std::uint32_t> first_of_b(body_count_ + 1, 0);
  for (const BodyPair& pair : pairs_) {
    ++first_of_b[index(pair.b) + 1];
  }
  std::partial_sum(first_of_b.begin(), first_of_b.end(), first_of_b.begin());
  std::vector<std::uint32_t> by_b(pairs_.size());
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    by_b[first_of_b[index(pairs_[i].b)]++] = static_cast<std::uint32_t>(i);
  }
  partners_.resize(pairs_.size());
  std::vector<std::uint32_t> next(first_partner_.begin(), first_partner_.end() - 1);
  for (const std::uint32_t i : by_b) {
    partners_[next[index(pairs_[i].a)]++] = {pairs_[i].b, PairId{i}};
  }
}

bool PairTable::find(BodyId one, BodyId other, PairId& id) const noexcept {
  const BodyId a = std::min(one, other);
  const BodyId b = std::max(one, other);
  if (!dense_.empty()) {
    const std::uint32_t found = dense_[index(a) * body_count_ + index(b)];
    id = found != kNone ? PairId{found} : id;
    return found != kNone;
  }
  const auto last = partners_.begin() + first_partner_[index(a) + 1];
  const auto found =
      std::lower_bound(partners_.begin() + first_partner_[index(a)], last, b,
                       [](const Partner& partner, BodyId body) { return partner.body < body; });
  if (found == last || found->body != b) {
    return false;
  }
  id = found->pair;
  return true;
}

}  // namespace collision_monitor
