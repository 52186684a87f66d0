// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause

// Transposes rows of numbers, one row per lane, into columns.
#if defined(COLLISION_MONITOR_GEOMETRY_TURN_ROWS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COLLISION_MONITOR_GEOMETRY_TURN_ROWS_INL_H_
#undef COLLISION_MONITOR_GEOMETRY_TURN_ROWS_INL_H_
#else
#define COLLISION_MONITOR_GEOMETRY_TURN_ROWS_INL_H_
#endif

#include "geometry/lanes/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

/// Four columns. Each lane holds its row's number.
struct FourNumbers {
  Number at[4];
};

#if HWY_MAX_BYTES >= 32
using Four = hn::CappedTag<double, 4>;

/// Transposes the rows of four lanes from `lane` on; half the time of a gather.
template <class RowOf>
HWY_INLINE void turnFour(const RowOf& rowOf, std::size_t lane, hn::Vec<Four> (&columns)[4]) {
  const auto one = hn::LoadU(Four(), rowOf(lane));
  const auto two = hn::LoadU(Four(), rowOf(lane + 1));
  const auto three = hn::LoadU(Four(), rowOf(lane + 2));
  const auto four = hn::LoadU(Four(), rowOf(lane + 3));
  const auto even_low = hn::InterleaveLower(Four(), one, two);
  const auto odd_low = hn::InterleaveUpper(Four(), one, two);
  const auto even_high = hn::InterleaveLower(Four(), three, four);
  const auto odd_high = hn::InterleaveUpper(Four(), three, four);
  columns[0] = hn::ConcatLowerLower(Four(), even_high, even_low);
  columns[1] = hn::ConcatLowerLower(Four(), odd_high, odd_low);
  columns[2] = hn::ConcatUpperUpper(Four(), even_high, even_low);
  columns[3] = hn::ConcatUpperUpper(Four(), odd_high, odd_low);
}
#endif

/// @param rowOf returns the address of a lane's four numbers.
template <class RowOf>
HWY_INLINE FourNumbers turnRows(const RowOf& rowOf) {
  FourNumbers numbers;
#if HWY_MAX_BYTES == 64
  hn::Vec<Four> low[4];
  hn::Vec<Four> high[4];
  turnFour(rowOf, 0, low);
  turnFour(rowOf, 4, high);
  for (std::size_t k = 0; k < 4; ++k) {
    numbers.at[k] = hn::Combine(Lanes(), high[k], low[k]);
  }
#elif HWY_MAX_BYTES == 32
  turnFour(rowOf, 0, numbers.at);
#else
  HWY_ALIGN double columns[4][hn::MaxLanes(Lanes())];
  for (std::size_t lane = 0; lane < hn::Lanes(Lanes()); ++lane) {
    for (std::size_t k = 0; k < 4; ++k) {
      columns[k][lane] = rowOf(lane)[k];
    }
  }
  for (std::size_t k = 0; k < 4; ++k) {
    numbers.at[k] = hn::Load(Lanes(), columns[k]);
  }
#endif
  return numbers;
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#endif
