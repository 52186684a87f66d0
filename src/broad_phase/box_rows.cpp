// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/broad_phase/box_rows.h"

#include <limits>

#include "broad_phase/row_pointers.h"
#include "collision_monitor/broad_phase/pair_table.h"
#include "collision_monitor/geometry/ids.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "broad_phase/box_rows.cpp"
#include <hwy/foreach_target.h>  // compiles what follows up to HWY_ONCE for every instruction set
#include <hwy/highway.h>

#include "broad_phase/pack_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

// Use no templates of the standard library here. The linker would keep one copy of each, perhaps
// one that this machine cannot run.
using Lanes = hn::CappedTag<float, kRowPadding>;

/// The rows from `other` on that meet `row` on the axis.
HWY_INLINE hn::Mask<Lanes> meetOnAxis(const RowPointers& rows, std::size_t row, std::size_t other,
                                      std::size_t axis) {
  const Lanes lanes;
  const auto begins =
      hn::Le(hn::LoadU(lanes, rows.min[axis] + other), hn::Set(lanes, rows.max[axis][row]));
  const auto ends =
      hn::Le(hn::Set(lanes, rows.min[axis][row]), hn::LoadU(lanes, rows.max[axis] + other));
  return hn::And(begins, ends);
}

HWY_INLINE void writePairs(std::size_t row, std::size_t other, std::uint32_t bits,
                           PairedRows& paired, RowPair* hits) {
  for (; bits != 0; bits &= bits - 1) {
    hits[paired.count++] = {
        static_cast<std::uint32_t>(row),
        static_cast<std::uint32_t>(other + hwy::Num0BitsBelowLS1Bit_Nonzero32(bits))};
  }
}

HWY_INLINE void pairRow(const RowPointers& rows, std::size_t row, std::size_t last,
                        PairedRows& paired, RowPair* hits) {
  for (std::size_t other = row + 1; other < last; other += hn::Lanes(Lanes())) {
    const auto meet =
        hn::And(hn::And(meetOnAxis(rows, row, other, 0), meetOnAxis(rows, row, other, 1)),
                meetOnAxis(rows, row, other, 2));
    writePairs(row, other, bitsOf(Lanes(), meet), paired, hits);
  }
  paired.seen += last - row - 1;
}

HWY_INLINE void sweepRow(const RowPointers& rows, std::size_t row, std::size_t axis,
                         PairedRows& paired, RowPair* hits) {
  const Lanes lanes;
  const std::size_t second = (axis + 1) % 3;
  const std::size_t third = (axis + 2) % 3;
  const auto end = hn::Set(lanes, rows.max[axis][row]);
  std::size_t other = row + 1;
  for (bool goes_on = true; goes_on; other += hn::Lanes(lanes)) {
    const auto begins = hn::Le(hn::LoadU(lanes, rows.min[axis] + other), end);
    const auto meet = hn::And(
        begins, hn::And(meetOnAxis(rows, row, other, second), meetOnAxis(rows, row, other, third)));
    writePairs(row, other, bitsOf(Lanes(), meet), paired, hits);
    goes_on = hn::AllTrue(lanes, begins);
  }
  paired.seen += other - row - 1;
}

/// Pairs one row; returns how many ids it wrote.
HWY_INLINE std::size_t pairRowOfTable(const RowPointers& rows, std::size_t row, std::size_t last,
                                      const std::uint32_t* ids, std::uint32_t* found) {
  const hn::Rebind<std::uint32_t, Lanes> integers;
  std::size_t count = 0;
  for (std::size_t other = row + 1; other < last; other += hn::Lanes(Lanes())) {
    const auto meet =
        hn::And(hn::And(meetOnAxis(rows, row, other, 0), meetOnAxis(rows, row, other, 1)),
                meetOnAxis(rows, row, other, 2));
    const auto id = hn::LoadU(integers, ids + row * last + other);
    const auto is_pair =
        hn::And(hn::RebindMask(integers, meet), hn::Ne(id, hn::Set(integers, kNone)));
    hn::StoreU(packed(id, is_pair), integers, found + count);
    count += hn::CountTrue(integers, is_pair);
  }
  return count;
}

PairedRows pairAllOfTable(const RowPointers& rows, const RowSpan& span, const std::uint32_t* ids,
                          std::uint32_t* found, std::size_t room) {
  PairedRows paired;
  std::size_t row = span.first;
  for (; row < span.last && paired.count + (span.last - row) + kRowPadding <= room; ++row) {
    paired.count += pairRowOfTable(rows, row, span.last, ids, found + paired.count);
    paired.seen += span.last - row - 1;
  }
  paired.next = row;
  return paired;
}

PairedRows pairAll(const RowPointers& rows, const RowSpan& span, RowPair* hits, std::size_t room) {
  PairedRows paired;
  std::size_t row = span.first;
  for (; row < span.last && paired.count + (span.last - row) <= room; ++row) {
    pairRow(rows, row, span.last, paired, hits);
  }
  paired.next = row;
  return paired;
}

PairedRows sweepSorted(const RowPointers& rows, const RowSpan& span, std::size_t axis,
                       RowPair* hits, std::size_t room) {
  PairedRows paired;
  std::size_t row = span.first;
  for (; row < span.last && paired.count + (span.last - row) <= room; ++row) {
    sweepRow(rows, row, axis, paired, hits);
  }
  paired.next = row;
  return paired;
}

}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace collision_monitor {
namespace {

HWY_EXPORT(pairAll);
HWY_EXPORT(sweepSorted);
HWY_EXPORT(pairAllOfTable);

RowPointers pointersTo(const BoxRows& rows) noexcept {
  return {{rows.min[0].data(), rows.min[1].data(), rows.min[2].data()},
          {rows.max[0].data(), rows.max[1].data(), rows.max[2].data()}};
}

}  // namespace

void reserveRows(std::size_t count, BoxRows& rows) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    rows.min[axis].reserve(count);
    rows.max[axis].reserve(count);
  }
  rows.bodies.reserve(count);
}

void resizeRows(std::size_t count, BoxRows& rows) noexcept {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    rows.min[axis].resize(count);
    rows.max[axis].resize(count);
  }
  rows.bodies.resize(count);
}

void padRows(std::size_t first, BoxRows& rows) noexcept {
  for (std::size_t row = first; row < first + kRowPadding; ++row) {
    setRow(row, 0, emptyBox(), rows);
  }
}

PairedRows pairRows(const BoxRows& rows, std::size_t row, std::size_t last,
                    std::vector<RowPair>& hits) noexcept {
  return HWY_DYNAMIC_DISPATCH(pairAll)(pointersTo(rows), {row, last}, hits.data(), hits.size());
}

PairedRows sweepRows(const BoxRows& rows, std::size_t row, std::size_t last, std::size_t axis,
                     std::vector<RowPair>& hits) noexcept {
  return HWY_DYNAMIC_DISPATCH(sweepSorted)(pointersTo(rows), {row, last}, axis, hits.data(),
                                           hits.size());
}

PairedRows pairRowsOfTable(const BoxRows& rows, std::size_t row, std::size_t last,
                           const std::uint32_t* ids, std::vector<std::uint32_t>& found) noexcept {
  return HWY_DYNAMIC_DISPATCH(pairAllOfTable)(pointersTo(rows), {row, last}, ids, found.data(),
                                              found.size());
}

}  // namespace collision_monitor
#endif
