// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/broad_phase/slab_sweep.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "broad_phase/spread.h"

namespace collision_monitor {
namespace {

constexpr std::size_t kRowsABody = 4;     ///< room for bodies that reach into several slabs
constexpr std::size_t kBodiesASlab = 64;  ///< not more slabs than that
constexpr double kSlabWidth = 4.0;        ///< in mean widths of a box
constexpr std::int32_t kFarSlab = 1 << 30;

std::size_t mostSlabs(std::size_t body_count) noexcept {
  std::size_t slabs = 1;
  while (slabs * 2 * kBodiesASlab <= body_count) {
    slabs *= 2;
  }
  return slabs;
}

/// How many boxes stand side by side along the axis.
double roomFor(const Spread& spread) noexcept { return spread.range / (spread.mean_width + 1e-9); }

}  // namespace

SlabSweep::SlabSweep(std::size_t body_count) : hits_(body_count) {
  const std::size_t slabs = mostSlabs(body_count);
  reserveRows(kRowsABody * body_count + slabs * kRowPadding, rows_);
  order_.reserve(body_count);
  scratch_.reserve(body_count);
  starts_.reserve(slabs + 1);
  ends_.reserve(slabs);
}

SlabSweep::Layout SlabSweep::layOut(const std::vector<SmallBox>& boxes) noexcept {
  const std::array<Spread, 3> spreads = spreadsOf(boxes);
  std::array<std::size_t, 3> axes{0, 1, 2};
  std::sort(axes.begin(), axes.end(), [&](std::size_t one, std::size_t other) {
    return std::make_pair(roomFor(spreads[other]), one) <
           std::make_pair(roomFor(spreads[one]), other);
  });
  Layout layout;
  layout.sweep_axis = axes[0];
  layout.slab_axis = axes[1];
  const Spread& spread = spreads[axes[1]];
  const double most = static_cast<double>(mostSlabs(boxes.size()));
  const double wanted = std::min(roomFor(spread) / kSlabWidth, most);
  layout.slabs_per_metre = spread.range > 0.0 ? wanted / spread.range : 0.0;
  std::int32_t slabs = 1;
  while (slabs < wanted) {
    slabs *= 2;
  }
  layout.slab_mask = std::min(slabs, static_cast<std::int32_t>(most)) - 1;
  return layout;
}

std::int32_t SlabSweep::slabAt(float coordinate) const noexcept {
  constexpr double kFar = 1e30;  // infinity times 0 would be no number
  const double slab = std::clamp<double>(coordinate, -kFar, kFar) * layout_.slabs_per_metre;
  return static_cast<std::int32_t>(std::floor(std::clamp<double>(slab, -kFarSlab, kFarSlab)));
}

/// Not so far behind the first that the body would stand in a slab twice.
std::int32_t SlabSweep::lastSlabOf(const SmallBox& box, std::int32_t first) const noexcept {
  return std::min(slabAt(box.max[layout_.slab_axis]), first + layout_.slab_mask);
}

/// Counts the rows of each slab into starts_[slab + 1]. False if there are too many.
bool SlabSweep::countRows(const std::vector<SmallBox>& boxes) noexcept {
  starts_.assign(static_cast<std::size_t>(layout_.slab_mask) + 2, 0);
  std::size_t rows = 0;
  order_.clear();
  for (std::size_t body = 0; body < boxes.size(); ++body) {
    const SmallBox& box = boxes[body];
    if (isEmpty(box)) {
      continue;
    }
    const std::int32_t first = slabAt(box.min[layout_.slab_axis]);
    const std::int32_t last = lastSlabOf(box, first);
    for (std::int32_t slab = first; slab <= last; ++slab) {
      ++starts_[static_cast<std::size_t>(slab & layout_.slab_mask) + 1];
    }
    rows += static_cast<std::size_t>(last - first + 1);
    order_.push_back((std::uint64_t{orderedBits(box.min[layout_.sweep_axis])} << 32) | body);
  }
  return rows <= kRowsABody * boxes.size();
}

void SlabSweep::fillRows(const std::vector<SmallBox>& boxes) noexcept {
  const std::size_t slabs = starts_.size() - 1;
  ends_.resize(slabs);
  for (std::size_t slab = 0; slab < slabs; ++slab) {
    starts_[slab + 1] += starts_[slab] + static_cast<std::uint32_t>(kRowPadding);
    ends_[slab] = starts_[slab];
  }
  resizeRows(starts_[slabs], rows_);
  for (std::size_t i = 0; i < order_.size(); ++i) {
    constexpr std::size_t kAhead = 16;  // bodies come in the order of places, not of memory
    __builtin_prefetch(
        &boxes[static_cast<std::uint32_t>(order_[std::min(i + kAhead, order_.size() - 1)])]);
    const auto body = static_cast<std::uint32_t>(order_[i]);
    const std::int32_t first = slabAt(boxes[body].min[layout_.slab_axis]);
    const std::int32_t last = lastSlabOf(boxes[body], first);
    for (std::int32_t slab = first; slab <= last; ++slab) {
      setRow(ends_[static_cast<std::size_t>(slab & layout_.slab_mask)]++, body, boxes[body], rows_);
    }
  }
  for (const std::uint32_t end : ends_) {
    padRows(end, rows_);
  }
}

void SlabSweep::sweepSlab(std::size_t slab, std::vector<PairKey>& found) noexcept {
  const std::vector<float>& begins = rows_.min[layout_.slab_axis];
  for (std::size_t row = starts_[slab]; row < ends_[slab]; ++row) {
    const RowHits hits = findBehindSorted(rows_, row, layout_.sweep_axis, hits_.data());
    work_ += hits.seen;
    for (std::size_t hit = 0; hit < hits.count; ++hit) {
      const std::size_t other = hits_[hit];
      const std::int32_t shared = slabAt(std::max(begins[row], begins[other]));
      if (static_cast<std::size_t>(shared & layout_.slab_mask) == slab) {
        found.push_back(pairKey(rows_.bodies[row], rows_.bodies[other]));
      }
    }
  }
}

void SlabSweep::findMeetings(const std::vector<SmallBox>& boxes,
                             std::vector<PairKey>& found) noexcept {
  found.clear();
  layout_ = layOut(boxes);
  while (!countRows(boxes)) {  // with one slab there is one row a body
    layout_.slabs_per_metre *= 0.5;
    layout_.slab_mask /= 2;
  }
  work_ = 0;
  radixSort({32, 32}, order_, scratch_);
  fillRows(boxes);
  for (std::size_t slab = 0; slab < ends_.size(); ++slab) {
    sweepSlab(slab, found);
  }
}

}  // namespace collision_monitor
