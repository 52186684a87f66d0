// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/broad_phase/box_rows.h"

#include <limits>

#include "broad_phase/row_pointers.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "broad_phase/box_rows.cpp"
#include <hwy/foreach_target.h>  // compiles what follows up to HWY_ONCE for every instruction set
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// No templates of the standard library in here: the linker would keep one copy of each, perhaps
// one that this machine cannot run.
using Lanes = hn::CappedTag<float, kRowPadding>;

std::size_t appendHits(std::size_t row, std::uint32_t bits, std::uint32_t* hits) {
  std::size_t count = 0;
  for (; bits != 0; bits &= bits - 1) {
    hits[count++] = static_cast<std::uint32_t>(row + hwy::Num0BitsBelowLS1Bit_Nonzero32(bits));
  }
  return count;
}

template <class Mask>
std::uint32_t bitsOf(Mask mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(Lanes(), mask, bytes);
  return bytes[0] | static_cast<std::uint32_t>(bytes[1] << 8);
}

/// Which of the rows from `other` on meet `row` on the axis.
HWY_INLINE hn::Mask<Lanes> meetOnAxis(const RowPointers& rows, std::size_t row, std::size_t other,
                                      std::size_t axis) {
  const Lanes lanes;
  const auto begins =
      hn::Le(hn::LoadU(lanes, rows.min[axis] + other), hn::Set(lanes, rows.max[axis][row]));
  const auto ends =
      hn::Le(hn::Set(lanes, rows.min[axis][row]), hn::LoadU(lanes, rows.max[axis] + other));
  return hn::And(begins, ends);
}

RowHits findAll(const RowPointers& rows, std::size_t row, std::size_t last, std::uint32_t* hits) {
  RowHits found;
  for (std::size_t other = row + 1; other < last; other += hn::Lanes(Lanes())) {
    const auto meet =
        hn::And(hn::And(meetOnAxis(rows, row, other, 0), meetOnAxis(rows, row, other, 1)),
                meetOnAxis(rows, row, other, 2));
    found.count += appendHits(other, bitsOf(meet), hits + found.count);
  }
  found.seen = last - row - 1;
  return found;
}

RowHits findSorted(const RowPointers& rows, std::size_t row, std::size_t axis,
                   std::uint32_t* hits) {
  const Lanes lanes;
  const std::size_t second = (axis + 1) % 3;
  const std::size_t third = (axis + 2) % 3;
  const auto end = hn::Set(lanes, rows.max[axis][row]);
  RowHits found;
  for (bool goes_on = true; goes_on;) {
    const std::size_t other = row + 1 + found.seen;
    const auto begins = hn::Le(hn::LoadU(lanes, rows.min[axis] + other), end);
    const auto meet = hn::And(
        begins, hn::And(meetOnAxis(rows, row, other, second), meetOnAxis(rows, row, other, third)));
    found.count += appendHits(other, bitsOf(meet), hits + found.count);
    found.seen += hn::Lanes(lanes);
    goes_on = hn::AllTrue(lanes, begins);
  }
  return found;
}

}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace collision_monitor {
namespace {

HWY_EXPORT(findAll);
HWY_EXPORT(findSorted);

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

void setRow(std::size_t row, std::uint32_t body, const SmallBox& box, BoxRows& rows) noexcept {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    rows.min[axis][row] = box.min[axis];
    rows.max[axis][row] = box.max[axis];
  }
  rows.bodies[row] = body;
}

void padRows(std::size_t first, BoxRows& rows) noexcept {
  for (std::size_t row = first; row < first + kRowPadding; ++row) {
    setRow(row, 0, emptyBox(), rows);
  }
}

RowHits findBehind(const BoxRows& rows, std::size_t row, std::size_t last,
                   std::uint32_t* hits) noexcept {
  return HWY_DYNAMIC_DISPATCH(findAll)(pointersTo(rows), row, last, hits);
}

RowHits findBehindSorted(const BoxRows& rows, std::size_t row, std::size_t axis,
                         std::uint32_t* hits) noexcept {
  return HWY_DYNAMIC_DISPATCH(findSorted)(pointersTo(rows), row, axis, hits);
}

}  // namespace collision_monitor
#endif
