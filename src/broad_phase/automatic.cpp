// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "broad_phase/automatic.h"

namespace collision_monitor {
namespace {

// Measured: docs/decisions/broad-phase.md.
constexpr std::size_t kVeryFewBodies = 40;
constexpr std::size_t kFewBodies = 600;
constexpr std::size_t kFewBodiesOfTable = 200;
constexpr std::size_t kMuchWork = 250;  ///< rows seen per body
constexpr std::size_t kManyPairs = 4;   ///< per body

/// The first calls of the list know nothing of the motion yet.
constexpr std::size_t kTrialCalls = 3;
constexpr std::size_t kCallsUntilNextTrial = 100;

}  // namespace

Automatic::Automatic(std::size_t body_count)
    : neighbour_list_(body_count), brute_force_(body_count), sweep_and_prune_(body_count) {}

Automatic::Method Automatic::chooseMethod(std::size_t body_count,
                                          std::size_t pair_count) const noexcept {
  if (!neighbour_list_.isCoherent()) {
    return body_count <= kFewBodies ? Method::brute_force : Method::neighbour_list;
  }
  const bool is_crowded =
      neighbour_list_.work() > kMuchWork * body_count && pair_count > kManyPairs * body_count;
  return is_crowded ? Method::sweep_and_prune : Method::neighbour_list;
}

void Automatic::findMeetings(const std::vector<SmallBox>& boxes,
                             std::vector<PairKey>& found) noexcept {
  const Method method = boxes.size() <= kVeryFewBodies ? Method::brute_force : method_;
  ++calls_;
  switch (method) {
    case Method::brute_force:
      brute_force_.findMeetings(boxes, found);
      break;
    case Method::sweep_and_prune:
      sweep_and_prune_.findMeetings(boxes, found);
      break;
    case Method::neighbour_list:
      neighbour_list_.findMeetings(boxes, found);
      if (calls_ >= kTrialCalls) {
        method_ = chooseMethod(boxes.size(), found.size());
        calls_ = method_ == method ? calls_ : 0;
      }
      return;
  }
  const bool is_disordered =
      method == Method::sweep_and_prune && calls_ > 1 && sweep_and_prune_.isAnew();
  if (calls_ >= kCallsUntilNextTrial || is_disordered) {
    method_ = Method::neighbour_list;
    calls_ = 0;
  }
}

bool Automatic::markPairs(const std::vector<SmallBox>& boxes, const PairTable& table,
                          MarkedPairs& marks) noexcept {
  const bool are_few = boxes.size() <= kFewBodiesOfTable;
  if (are_few) {
    brute_force_.markPairs(boxes, table, marks);
  }
  return are_few;
}

}  // namespace collision_monitor
