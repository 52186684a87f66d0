// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "broad_phase/methods/brute_force.h"

namespace collision_monitor {

BruteForce::BruteForce(std::size_t body_count)
    : hits_(body_count), ids_(4 * body_count + kRowPadding) {
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

void BruteForce::markPairs(const std::vector<SmallBox>& boxes, const PairTable& table,
                           MarkedPairs& marks) noexcept {
  const std::size_t last = boxes.size();
  resizeRows(last + kRowPadding, rows_);
  for (std::size_t body = 0; body < last; ++body) {
    setRow(body, static_cast<std::uint32_t>(body), boxes[body], rows_);
  }
  padRows(last, rows_);
  for (std::size_t row = 0; row < last;) {
    const PairedRows paired = pairRowsOfTable(rows_, row, last, table.idsOfAll(), ids_);
    row = paired.next;
    for (std::size_t i = 0; i < paired.count; ++i) {
      markPair(ids_[i], marks);
    }
  }
}

}  // namespace collision_monitor
