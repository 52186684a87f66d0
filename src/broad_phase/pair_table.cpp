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
    fillRuns();
  }
}

void PairTable::fillDense() {
  dense_.resize(body_count_ * body_count_ + kRowPadding, kNone);
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    assert(pairs_[i].a < pairs_[i].b && index(pairs_[i].b) < body_count_);
    dense_[index(pairs_[i].a) * body_count_ + index(pairs_[i].b)] = static_cast<std::uint32_t>(i);
  }
}

void PairTable::fillRuns() {
  const auto starts_run = [&](std::size_t i) {
    return i == 0 || pairs_[i].a != pairs_[i - 1].a || pairs_[i].b < pairs_[i - 1].b;
  };
  first_run_.resize(body_count_ + 1, 0);
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    assert(pairs_[i].a < pairs_[i].b && index(pairs_[i].b) < body_count_);
    first_run_[index(pairs_[i].a) + 1] += starts_run(i) ? 1 : 0;
  }
  std::partial_sum(first_run_.begin(), first_run_.end(), first_run_.begin());
  runs_.resize(first_run_.back());
  std::vector<std::uint32_t> next(first_run_.begin(), first_run_.end() - 1);
  Run* run = nullptr;
  for (std::uint32_t i = 0; i < pairs_.size(); ++i) {
    if (starts_run(i)) {
      run = &runs_[next[index(pairs_[i].a)]++];
      run->first = i;
    }
    run->last = i + 1;
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
  for (std::uint32_t i = first_run_[index(a)]; i < first_run_[index(a) + 1]; ++i) {
    const auto last = pairs_.begin() + runs_[i].last;
    const auto found =
        std::lower_bound(pairs_.begin() + runs_[i].first, last, b,
                         [](const BodyPair& pair, BodyId body) { return pair.b < body; });
    if (found != last && found->b == b) {
      id = PairId{static_cast<std::uint32_t>(found - pairs_.begin())};
      return true;
    }
  }
  return false;
}

}  // namespace collision_monitor
