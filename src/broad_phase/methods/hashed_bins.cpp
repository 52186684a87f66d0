// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "broad_phase/methods/hashed_bins.h"

#include <algorithm>
#include <cmath>

#include "broad_phase/box_tests.h"
#include "broad_phase/spread.h"
#include "collision_monitor/geometry/ids.h"

namespace collision_monitor {
namespace {

constexpr double kCellWidth = 2.0;  ///< in mean widths of a box
constexpr std::int64_t kMostCells = 64;
constexpr std::int32_t kFarCell = 1 << 20;
constexpr std::size_t kEntriesABody = 8;
constexpr std::size_t kAllEntriesUpTo = 1000;  ///< bodies: up to here, room for kMostCells each

/// The cell's coordinates, 21 bits per axis.
std::uint64_t packed(std::int32_t x, std::int32_t y, std::int32_t z) noexcept {
  const auto bits = [](std::int32_t cell) {
    return static_cast<std::uint64_t>(cell + kFarCell) & 0x1fffffU;
  };
  return bits(x) | (bits(y) << 21) | (bits(z) << 42);
}

template <class Range, class Visit>
void forCells(const Range& range, const Visit& visit) noexcept {
  for (std::int32_t x = range.first[0]; x <= range.last[0]; ++x) {
    for (std::int32_t y = range.first[1]; y <= range.last[1]; ++y) {
      for (std::int32_t z = range.first[2]; z <= range.last[2]; ++z) {
        visit(x, y, z);
      }
    }
  }
}

template <class Range>
bool holds(const Range& range, std::int32_t x, std::int32_t y, std::int32_t z) noexcept {
  return range.first[0] <= x && x <= range.last[0] && range.first[1] <= y && y <= range.last[1] &&
         range.first[2] <= z && z <= range.last[2];
}

template <class Range>
bool isWide(const Range& range) noexcept {
  std::int64_t cells = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    cells =
        std::min<std::int64_t>(cells * (range.last[axis] - range.first[axis] + 1), kMostCells + 1);
  }
  return cells > kMostCells;
}

}  // namespace

HashedBins::HashedBins(std::size_t body_count)
    : free_(kNone), cells_(body_count), places_(body_count, Place::nowhere) {
  std::size_t bins = 1;
  while (bins < 2 * body_count) {
    bins *= 2;
  }
  heads_.resize(bins, kNone);
  const std::size_t counted = std::min(body_count, kAllEntriesUpTo);
  entries_.reserve(counted * kMostCells + (body_count - counted) * kEntriesABody);
}

/// Whether the cell width still fits the boxes; sets it anew if not.
bool HashedBins::suitsCells(const std::vector<SmallBox>& boxes) noexcept {
  double mean_width = 0.0;
  for (const Spread& spread : spreadsOf(boxes)) {
    mean_width += spread.mean_width / 3.0;
  }
  const double wanted = mean_width > 0.0 ? 1.0 / (kCellWidth * mean_width) : 1.0;
  if (cells_per_metre_ > 0.5 * wanted && cells_per_metre_ < 2.0 * wanted) {
    return true;
  }
  cells_per_metre_ = wanted;
  return false;
}

void HashedBins::clear() noexcept {
  std::fill(heads_.begin(), heads_.end(), kNone);
  std::fill(places_.begin(), places_.end(), Place::nowhere);
  entries_.clear();
  free_ = kNone;
}

std::int32_t HashedBins::cellAt(float coordinate) const noexcept {
  constexpr double kFar = 1e30;
  const double cell = std::clamp<double>(coordinate, -kFar, kFar) * cells_per_metre_;
  return static_cast<std::int32_t>(std::floor(std::clamp<double>(cell, -kFarCell, kFarCell - 1)));
}

HashedBins::CellRange HashedBins::cellsOf(const SmallBox& box) const noexcept {
  CellRange range;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    range.first[axis] = cellAt(box.min[axis]);
    range.last[axis] = cellAt(box.max[axis]);
  }
  return range;
}

std::uint64_t HashedBins::sharedCell(const SmallBox& a, const SmallBox& b) const noexcept {
  return packed(cellAt(std::max(a.min[0], b.min[0])), cellAt(std::max(a.min[1], b.min[1])),
                cellAt(std::max(a.min[2], b.min[2])));
}

/// Hashes with the primes of Teschner et al.
std::uint32_t& HashedBins::headOf(std::uint64_t cell) noexcept {
  const std::uint64_t hash = ((cell & 0x1fffffU) * 73856093U) ^
                             (((cell >> 21) & 0x1fffffU) * 19349663U) ^ ((cell >> 42) * 83492791U);
  return heads_[hash & (heads_.size() - 1)];
}

void HashedBins::enter(std::uint32_t body, std::uint64_t cell) noexcept {
  std::uint32_t entry = free_;
  if (entry != kNone) {
    free_ = entries_[entry].next;
  } else {
    entry = static_cast<std::uint32_t>(entries_.size());
    entries_.emplace_back();
  }
  std::uint32_t& head = headOf(cell);
  entries_[entry] = {cell, body, head};
  head = entry;
}

void HashedBins::leave(std::uint32_t body, std::uint64_t cell) noexcept {
  std::uint32_t* link = &headOf(cell);
  while (entries_[*link].body != body || entries_[*link].cell != cell) {
    link = &entries_[*link].next;
  }
  const std::uint32_t entry = *link;
  *link = entries_[entry].next;
  entries_[entry].next = free_;
  free_ = entry;
}

/// Enters the cells that the box newly overlaps and leaves those it no longer overlaps.
void HashedBins::move(std::uint32_t body, const SmallBox& box) noexcept {
  const CellRange before = cells_[body];
  const bool was_in_cells = places_[body] == Place::cells;
  if (isEmpty(box)) {
    places_[body] = Place::nowhere;
  } else {
    cells_[body] = cellsOf(box);
    places_[body] = isWide(cells_[body]) ? Place::aside : Place::cells;
  }
  const CellRange& now = cells_[body];
  const bool is_in_cells = places_[body] == Place::cells;
  if (was_in_cells && is_in_cells && before.first == now.first && before.last == now.last) {
    return;
  }
  if (was_in_cells) {
    forCells(before, [&](std::int32_t x, std::int32_t y, std::int32_t z) {
      if (!is_in_cells || !holds(now, x, y, z)) {
        leave(body, packed(x, y, z));
      }
    });
  }
  if (is_in_cells) {
    forCells(now, [&](std::int32_t x, std::int32_t y, std::int32_t z) {
      if (!was_in_cells || !holds(before, x, y, z)) {
        enter(body, packed(x, y, z));
      }
    });
  }
}

void HashedBins::findInBin(std::uint32_t head, const std::vector<SmallBox>& boxes,
                           std::vector<PairKey>& found) const noexcept {
  for (std::uint32_t one = head; one != kNone; one = entries_[one].next) {
    const Entry& entry = entries_[one];
    const SmallBox& box = boxes[entry.body];
    for (std::uint32_t other = entry.next; other != kNone; other = entries_[other].next) {
      const Entry& partner = entries_[other];
      const SmallBox& partner_box = boxes[partner.body];
      if (partner.cell == entry.cell && meets(box, partner_box) &&
          sharedCell(box, partner_box) == entry.cell) {
        found.push_back(pairKey(entry.body, partner.body));
      }
    }
  }
}

void HashedBins::findAside(const std::vector<SmallBox>& boxes,
                           std::vector<PairKey>& found) const noexcept {
  for (std::size_t wide = 0; wide < boxes.size(); ++wide) {
    if (places_[wide] != Place::aside) {
      continue;
    }
    for (std::size_t other = 0; other < boxes.size(); ++other) {
      const bool is_met_before = other <= wide && places_[other] == Place::aside;
      if (!is_met_before && meets(boxes[wide], boxes[other])) {
        found.push_back(
            pairKey(static_cast<std::uint32_t>(wide), static_cast<std::uint32_t>(other)));
      }
    }
  }
}

void HashedBins::findMeetings(const std::vector<SmallBox>& boxes,
                              std::vector<PairKey>& found) noexcept {
  if (!suitsCells(boxes)) {
    clear();
  }
  for (std::size_t body = 0; body < boxes.size(); ++body) {
    move(static_cast<std::uint32_t>(body), boxes[body]);
  }
  found.clear();
  for (const std::uint32_t head : heads_) {
    findInBin(head, boxes, found);
  }
  findAside(boxes, found);
}

}  // namespace collision_monitor
