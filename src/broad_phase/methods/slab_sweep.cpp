// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "broad_phase/methods/slab_sweep.h"

#include <algorithm>
#include <array>
#include <utility>

#include "broad_phase/spread.h"

namespace collision_monitor {
namespace {

constexpr std::size_t kRowsABody = 4;       ///< room for bodies that overlap several columns
constexpr std::size_t kBodiesAColumn = 32;  ///< limits the number of columns
constexpr double kSlabWidth = 4.0;          ///< in mean widths of a box
constexpr std::int32_t kFarSlab = 1 << 30;

std::size_t mostColumns(std::size_t body_count) noexcept {
  std::size_t columns = 1;
  while (columns * 2 * kBodiesAColumn <= body_count) {
    columns *= 2;
  }
  return columns;
}

/// How many boxes fit side by side along the axis.
double roomFor(const Spread& spread) noexcept { return spread.range / (spread.mean_width + 1e-9); }

/// Rounds down without std::floor, which costs more than all the rest.
std::int32_t slabAt(double per_metre, float coordinate) noexcept {
  constexpr double kFar = 1e30;  // infinity times 0 would be NaN
  const double slab = std::clamp(std::clamp<double>(coordinate, -kFar, kFar) * per_metre,
                                 -double{kFarSlab}, double{kFarSlab});
  const auto truncated = static_cast<std::int32_t>(slab);
  return truncated - (slab < truncated ? 1 : 0);
}

}  // namespace

SlabSweep::SlabSweep(std::size_t body_count) : reaches_(body_count), hits_(body_count) {
  const std::size_t columns = mostColumns(body_count);
  reserveRows(kRowsABody * body_count + columns * kRowPadding, rows_);
  order_.reserve(body_count);
  scratch_.reserve(body_count);
  starts_.reserve(columns + 1);
  ends_.reserve(columns);
}

SlabSweep::Layout SlabSweep::layOut(const std::vector<SmallBox>& boxes) noexcept {
  const std::array<Spread, 3> spreads = spreadsOf(boxes);
  std::array<std::size_t, 3> axes{0, 1, 2};
  std::sort(axes.begin(), axes.end(), [&](std::size_t one, std::size_t other) {
    return std::make_pair(roomFor(spreads[other]), one) <
           std::make_pair(roomFor(spreads[one]), other);
  });
  const auto most = static_cast<std::int32_t>(mostColumns(boxes.size()));
  std::array<std::int32_t, 2> counts{1, 1};
  for (std::size_t i = 0; i < 2; ++i) {
    while (counts[i] < roomFor(spreads[axes[i + 1]]) / kSlabWidth && counts[i] < most) {
      counts[i] *= 2;
    }
  }
  while (counts[0] * counts[1] > most) {
    counts[counts[1] >= counts[0] ? 1 : 0] /= 2;
  }
  Layout layout;
  layout.sweep_axis = axes[0];
  for (std::size_t i = 0; i < 2; ++i) {
    const Spread& spread = spreads[axes[i + 1]];
    const double wanted = std::min<double>(roomFor(spread) / kSlabWidth, counts[i]);
    layout.slabs[i] = {axes[i + 1], spread.range > 0.0 ? wanted / spread.range : 0.0,
                       counts[i] - 1};
  }
  return layout;
}

std::size_t SlabSweep::columnAt(std::int32_t slab, std::int32_t other_slab) const noexcept {
  const auto& [slabs, others] = layout_.slabs;
  const auto across = static_cast<std::size_t>(others.mask) + 1;
  return static_cast<std::size_t>(slab & slabs.mask) * across +
         static_cast<std::size_t>(other_slab & others.mask);
}

template <class Visit>
void SlabSweep::forColumns(const Reach& reach, const Visit& visit) const noexcept {
  for (std::int32_t slab = reach.first[0]; slab <= reach.last[0]; ++slab) {
    for (std::int32_t other = reach.first[1]; other <= reach.last[1]; ++other) {
      visit(columnAt(slab, other));
    }
  }
}

/// Counts the rows of each column into starts_[column + 1]. False if there are too many.
bool SlabSweep::countRows(const std::vector<SmallBox>& boxes) noexcept {
  starts_.assign(columnAt(-1, -1) + 2, 0);  // slab -1 has the last number
  std::size_t rows = 0;
  order_.clear();
  for (std::size_t body = 0; body < boxes.size(); ++body) {
    const SmallBox& box = boxes[body];
    if (isEmpty(box)) {
      continue;
    }
    Reach& reach = reaches_[body];
    for (std::size_t i = 0; i < 2; ++i) {
      const Slabs& slabs = layout_.slabs[i];
      reach.first[i] = slabAt(slabs.per_metre, box.min[slabs.axis]);
      // Limited, so that the body is not in a slab twice.
      reach.last[i] =
          std::min(slabAt(slabs.per_metre, box.max[slabs.axis]), reach.first[i] + slabs.mask);
    }
    forColumns(reach, [&](std::size_t column) {
      ++starts_[column + 1];
      ++rows;
    });
    order_.push_back((std::uint64_t{orderedBits(box.min[layout_.sweep_axis])} << 32) | body);
  }
  return rows <= kRowsABody * boxes.size();
}

/// Halves the number of slabs on the axis that has more. A single column has one row per body.
void SlabSweep::widenSlabs() noexcept {
  Slabs& slabs = layout_.slabs[layout_.slabs[1].mask >= layout_.slabs[0].mask ? 1 : 0];
  slabs.per_metre *= 0.5;
  slabs.mask /= 2;
}

void SlabSweep::fillRows(const std::vector<SmallBox>& boxes) noexcept {
  const std::size_t columns = starts_.size() - 1;
  ends_.resize(columns);
  for (std::size_t column = 0; column < columns; ++column) {
    starts_[column + 1] += starts_[column] + static_cast<std::uint32_t>(kRowPadding);
    ends_[column] = starts_[column];
  }
  resizeRows(starts_[columns], rows_);
  for (std::size_t i = 0; i < order_.size(); ++i) {
    constexpr std::size_t kAhead = 16;  // bodies come in the order of places, not of memory
    const auto soon = static_cast<std::uint32_t>(order_[std::min(i + kAhead, order_.size() - 1)]);
    __builtin_prefetch(&boxes[soon]);
    __builtin_prefetch(&reaches_[soon]);
    const auto body = static_cast<std::uint32_t>(order_[i]);
    forColumns(reaches_[body],
               [&](std::size_t column) { setRow(ends_[column]++, body, boxes[body], rows_); });
  }
  for (const std::uint32_t end : ends_) {
    padRows(end, rows_);
  }
}

void SlabSweep::sweepColumn(std::size_t column, std::vector<PairKey>& found) noexcept {
  for (std::size_t row = starts_[column]; row < ends_[column];) {
    const PairedRows swept = sweepRows(rows_, row, ends_[column], layout_.sweep_axis, hits_);
    row = swept.next;
    work_ += swept.seen;
    for (std::size_t hit = 0; hit < swept.count; ++hit) {
      const std::uint32_t one = rows_.bodies[hits_[hit].row];
      const std::uint32_t other = rows_.bodies[hits_[hit].other];
      const auto& first = reaches_[one].first;
      const auto& other_first = reaches_[other].first;
      if (columnAt(std::max(first[0], other_first[0]), std::max(first[1], other_first[1])) ==
          column) {
        found.push_back(pairKey(one, other));
      }
    }
  }
}

void SlabSweep::findMeetings(const std::vector<SmallBox>& boxes,
                             std::vector<PairKey>& found) noexcept {
  found.clear();
  layout_ = layOut(boxes);
  while (!countRows(boxes)) {
    widenSlabs();
  }
  work_ = 0;
  radixSort({32, 32}, order_, scratch_);
  fillRows(boxes);
  for (std::size_t column = 0; column < ends_.size(); ++column) {
    sweepColumn(column, found);
  }
}

}  // namespace collision_monitor
