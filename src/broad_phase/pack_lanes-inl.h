// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause

// Masks of lanes as bits, and lanes moved together. Compiled once for each instruction set.
#if defined(COLLISION_MONITOR_PACK_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef COLLISION_MONITOR_PACK_LANES_INL_H
#undef COLLISION_MONITOR_PACK_LANES_INL_H
#else
#define COLLISION_MONITOR_PACK_LANES_INL_H
#endif

#include <hwy/highway.h>

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class D, class Mask>
HWY_INLINE std::uint32_t bitsOf(D lanes, Mask mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(lanes, mask, bytes);
  return bytes[0] | static_cast<std::uint32_t>(bytes[1] << 8);
}

#if HWY_TARGET == HWY_AVX2
/// By mask: the numbers of its lanes, four bits each, the first in the lowest bits.
struct LaneNumbers {
  std::uint32_t of_mask[256];
};

constexpr LaneNumbers numberLanes() {
  LaneNumbers numbers{};
  for (std::uint32_t mask = 0; mask < 256; ++mask) {
    std::uint32_t shift = 0;
    for (std::uint32_t lane = 0; lane < 8; ++lane) {
      if ((mask >> lane & 1U) != 0) {
        numbers.of_mask[mask] |= lane << shift;
        shift += 4;
      }
    }
  }
  return numbers;
}

constexpr LaneNumbers kLaneNumbers = numberLanes();
#endif

/// Moves the lanes of the mask to the front; the rest is undefined. CompressStore is very slow on
/// some processors. Where Highway builds Compress from a table, GCC copies that table, 1 KB, to the
/// stack each time.
/// @param ids whole numbers of 32 bits
template <class Ids, class Mask>
HWY_INLINE Ids packed(Ids ids, Mask mask) {
#if HWY_TARGET == HWY_AVX2
  const hn::DFromV<Ids> integers;
  const std::uint32_t bits = bitsOf(integers, mask);
  const auto shifts = hn::Mul(hn::Iota(integers, 0), hn::Set(integers, 4));
  const auto numbers = hn::Shr(hn::Set(integers, kLaneNumbers.of_mask[bits]), shifts);
  const auto lanes = hn::And(numbers, hn::Set(integers, 7));
  return hn::TableLookupLanes(ids, hn::IndicesFromVec(integers, lanes));
#else
  return hn::Compress(ids, mask);
#endif
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#endif
