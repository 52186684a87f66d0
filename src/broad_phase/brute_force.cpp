// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/broad_phase/brute_force.h"

namespace collision_monitor {

BruteForce::BruteForce(std::size_t body_count) : hits_(body_count) {
  reserveRows(body_count + kRowPadding, rows_);
}

void BruteForce::findMeetings(const std::vector<SmallBox>& boxes,
                              std::vector<PairKey>& found) noexcept {
  found.clear();
  resizeRows(boxes.size() + kRowPadding, rows_);
  std::size_t known = 0;
  for (std::size_t body = 0; body < boxes.size(); ++body) {
    if (!isEmpty(boxes[body])) {
      setRow(known++, static_cast<std::uint32_t>(body), boxes[body], rows_);
    }
  }
  padRows(known, rows_);
  for (std::size_t row = 0; row < known;) {
    const PairedRows paired = pairRows(rows_, row, known, hits_);
    row = paired.next;
    for (std::size_t hit = 0; hit < paired.count; ++hit) {
      found.push_back(pairKey(rows_.bodies[hits_[hit].row], rows_.bodies[hits_[hit].other]));
    }
  }
}

}  // namespace collision_monitor
