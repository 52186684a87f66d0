// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "broad_phase/methods/sweep_and_prune.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include "broad_phase/box_tests.h"

namespace collision_monitor {
namespace {

constexpr std::uint64_t kUpperEnd = std::uint64_t{1} << 31;
/// Insertion is given up when this many end points per body pass others in one call.
constexpr std::size_t kPassesABody = 32;
constexpr std::size_t kPairsABody = 4;  ///< room for pairs added in one call

std::uint32_t bodyOf(std::uint64_t end) noexcept {
  return static_cast<std::uint32_t>(end & (kUpperEnd - 1));
}

bool isUpper(std::uint64_t end) noexcept { return (end & kUpperEnd) != 0; }

}  // namespace

SweepAndPrune::SweepAndPrune(std::size_t body_count) : slot_in_active_(body_count, 0) {
  active_.reserve(body_count);
  scratch_.reserve(std::max(2 * body_count, roomForPairs(body_count)));
  pairs_.reserve(roomForPairs(body_count));
  added_.reserve(kPairsABody * body_count);
  for (EndPoints& axis : axes_) {
    axis.reserve(2 * body_count);
    for (std::size_t body = 0; body < body_count; ++body) {
      axis.push_back(body);
      axis.push_back(body | kUpperEnd);
    }
  }
}

void SweepAndPrune::findMeetings(const std::vector<SmallBox>& boxes,
                                 std::vector<PairKey>& found) noexcept {
  moveEndPoints(boxes);
  is_anew_ = !is_sorted_ || !sortByInsertion(boxes);
  if (is_anew_) {
    startAnew(boxes);
  } else {
    updatePairs(boxes, found);
  }
  found = pairs_;
}

/// An unknown body ends before all others and begins behind them. So its ends pass those of every
/// body that it meets when it becomes known, and again when it becomes unknown.
void SweepAndPrune::moveEndPoints(const std::vector<SmallBox>& boxes) noexcept {
  constexpr std::uint64_t kBeforeAll = 0;
  constexpr std::uint64_t kBehindAll = 0xffffffffU;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (EndPoint& end : axes_[axis]) {
      const SmallBox& box = boxes[bodyOf(end)];
      const std::uint64_t position =
          isEmpty(box) ? (isUpper(end) ? kBeforeAll : kBehindAll)
                       : orderedBits(isUpper(end) ? box.max[axis] : box.min[axis]);
      end = (position << 32) | (end & 0xffffffffU);
    }
  }
}

/// Notes the pairs that begin to meet, and whether any may part. Returns false if it gave up
/// because the axes are too disordered.
bool SweepAndPrune::sortByInsertion(const std::vector<SmallBox>& boxes) noexcept {
  added_.clear();
  have_parted_ = false;
  std::size_t passes_left = kPassesABody * boxes.size();
  for (EndPoints& axis : axes_) {
    for (std::size_t i = 1; i < axis.size(); ++i) {
      const EndPoint moved = axis[i];
      std::size_t gap = i;
      for (; gap > 0 && moved < axis[gap - 1]; --gap) {
        pass(moved, axis[gap - 1], boxes);
        axis[gap] = axis[gap - 1];
      }
      axis[gap] = moved;
      if (i - gap > passes_left || added_.size() + axis.size() > added_.capacity()) {
        return false;
      }
      passes_left -= i - gap;
    }
  }
  return true;
}

void SweepAndPrune::pass(EndPoint moved, EndPoint passed,
                         const std::vector<SmallBox>& boxes) noexcept {
  if (isUpper(moved) == isUpper(passed) || bodyOf(moved) == bodyOf(passed)) {
    return;
  }
  if (isUpper(moved)) {
    have_parted_ = true;
  } else if (meets(boxes[bodyOf(moved)], boxes[bodyOf(passed)])) {
    added_.push_back(pairKey(bodyOf(moved), bodyOf(passed)));
  }
}

void SweepAndPrune::updatePairs(const std::vector<SmallBox>& boxes,
                                std::vector<PairKey>& found) noexcept {
  if (have_parted_) {
    const auto has_parted = [&](PairKey pair) {
      return !meets(boxes[lowerBody(pair)], boxes[upperBody(pair)]);
    };
    pairs_.erase(std::remove_if(pairs_.begin(), pairs_.end(), has_parted), pairs_.end());
  }
  if (!added_.empty()) {
    std::sort(added_.begin(), added_.end());
    added_.erase(std::unique(added_.begin(), added_.end()), added_.end());
    found.clear();
    std::set_union(pairs_.begin(), pairs_.end(), added_.begin(), added_.end(),
                   std::back_inserter(found));
    pairs_.swap(found);
  }
}

void SweepAndPrune::startAnew(const std::vector<SmallBox>& boxes) noexcept {
  for (EndPoints& axis : axes_) {
    radixSort({0, 64}, axis, scratch_);
  }
  is_sorted_ = true;
  pairs_.clear();
  active_.clear();
  for (const EndPoint end : axes_[leastCrowdedAxis(boxes)]) {
    if (isEmpty(boxes[bodyOf(end)])) {
      continue;
    }
    if (isUpper(end)) {
      close(bodyOf(end));
    } else {
      open(bodyOf(end), boxes);
    }
  }
  sortPairs(boxes.size(), pairs_, scratch_);
}

/// The number of overlapping intervals on an axis is the sum, over all openings, of the intervals
/// open at that moment.
std::size_t SweepAndPrune::leastCrowdedAxis(const std::vector<SmallBox>& boxes) const noexcept {
  std::size_t best_axis = 0;
  std::size_t fewest = std::numeric_limits<std::size_t>::max();
  for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
    std::size_t overlaps = 0;
    std::size_t open_now = 0;
    for (const EndPoint end : axes_[axis]) {
      if (isEmpty(boxes[bodyOf(end)])) {
        continue;
      }
      if (isUpper(end)) {
        --open_now;
      } else {
        overlaps += open_now++;
      }
    }
    if (overlaps < fewest) {
      fewest = overlaps;
      best_axis = axis;
    }
  }
  return best_axis;
}

void SweepAndPrune::open(std::uint32_t body, const std::vector<SmallBox>& boxes) noexcept {
  for (const std::uint32_t other : active_) {
    if (meets(boxes[body], boxes[other])) {
      pairs_.push_back(pairKey(body, other));
    }
  }
  slot_in_active_[body] = static_cast<std::uint32_t>(active_.size());
  active_.push_back(body);
}

void SweepAndPrune::close(std::uint32_t body) noexcept {
  const std::uint32_t slot = slot_in_active_[body];
  active_[slot] = active_.back();
  slot_in_active_[active_[slot]] = slot;
  active_.pop_back();
}

}  // namespace collision_monitor
