// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Measures one body against several neighbours at once.
#if defined(COLLISION_MONITOR_BLOCK_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef COLLISION_MONITOR_BLOCK_LANES_INL_H
#undef COLLISION_MONITOR_BLOCK_LANES_INL_H
#else
#define COLLISION_MONITOR_BLOCK_LANES_INL_H
#endif

#include <limits>
#include <utility>
#include <vector>

#include "collision_monitor/pipeline/pair_blocks.h"
#include "narrow_phase/simd/lanes_box_box-inl.h"
#include "narrow_phase/simd/lanes_points-inl.h"
#include "narrow_phase/simd/lanes_segment_box-inl.h"
#include "narrow_phase/simd/plain_twin.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

constexpr std::size_t kLanes = hn::MaxLanes(Lanes());

/// The lanes of a block in one vector.
struct BlockPart {
  std::uint32_t one;         ///< slot
  std::size_t first;         ///< slot
  std::uint32_t is_pair;     ///< bit by lane of the vector
  std::uint32_t first_pair;  ///< PairId of the lowest bit
};

/// Calls `visit` with the first lane and the part of each vector of a block that has pairs, until
/// `visit` returns false.
/// @return false if it did.
template <class Visit>
HWY_INLINE bool forParts(const PairBlock& block, const Visit& visit) {
  std::uint32_t pair = block.first_pair;
  for (std::size_t lane = 0; lane < kBlockLanes; lane += kLanes) {
    const std::uint32_t is_pair = (block.is_pair >> lane) & ((1U << kLanes) - 1U);
    if (is_pair != 0 && !visit(lane, BlockPart{block.one, block.first + lane, is_pair, pair})) {
      return false;
    }
    pair += static_cast<std::uint32_t>(hwy::PopCount(is_pair));
  }
  return true;
}

HWY_INLINE std::uint32_t bitsOf(Truth truth) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(Lanes(), truth, bits);
  return bits[0];
}

/// Lanes that are NaN. Highway's Ne does not find NaN on every instruction set.
HWY_INLINE std::uint32_t nansOf(Number value) { return bitsOf(hn::Not(hn::Eq(value, value))); }

HWY_INLINE Truth truthOf(std::uint32_t bits) {
  const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(bits)};
  return hn::LoadMaskBits(Lanes(), bytes);
}

/// The core in slot `one`, in every lane.
template <class Core>
HWY_INLINE Core coreOfOne(const BodyRows& rows, const BlockPart& part) {
  return Core(OneShape{rows.numbers.data() + part.one, rows.stride});
}

/// The cores from slot `first` on, one in each lane.
template <class Core>
HWY_INLINE Core coreOfRow(const BodyRows& rows, const BlockPart& part) {
  return Core(ShapeLanes{rows.numbers.data() + part.first, rows.stride});
}

/// Whether bounding spheres allow a pair to be as near as `best`.
HWY_INLINE Truth mayBeNearer(const BodyRows& rows, const BlockPart& part, double best) {
  const ShapeLanes row{rows.numbers.data() + part.first, rows.stride};
  const OneShape one{rows.numbers.data() + part.one, rows.stride};
  const Vector3 between = vectorAt(row, column::center) - vectorAt(one, column::center);
  const Number radii = hn::Add(one.at(kBoundingColumn), row.at(kBoundingColumn));
  const Number allowed = hn::Add(radii, number(best));
  return hn::Not(hn::Gt(dot(between, between), hn::Mul(allowed, allowed)));
}

/// The distance of one lane by the plain twin. Takes the part by value, as `finished` does: if its
/// address were taken, each block would write it to memory.
template <class CoreOne, class CoreRow>
HWY_NOINLINE double plainAt(const BodyRows& rows, BlockPart part, std::size_t lane) {
  PosedCore a = readCore(CoreOne::kKind, rows.numbers.data() + part.one, rows.stride);
  PosedCore b = readCore(CoreRow::kKind, rows.numbers.data() + part.first + lane, rows.stride);
  if (CoreOne::kKind > CoreRow::kKind) {
    std::swap(a, b);
  }
  return plainDistance(a.core, a.pose, b.core, b.pose).distance;
}

/// Measures the lanes `which` by the plain twin.
template <class CoreOne, class CoreRow>
HWY_NOINLINE Number finished(const BodyRows& rows, BlockPart part, std::uint32_t which,
                             Number distance) {
  HWY_ALIGN double distances[kLanes];
  hn::Store(distance, Lanes(), distances);
  for (; which != 0; which &= which - 1) {
    const auto lane = static_cast<std::size_t>(__builtin_ctz(which));
    distances[lane] = plainAt<CoreOne, CoreRow>(rows, part, lane);
  }
  return hn::Load(Lanes(), distances);
}

/// Measures by the plain twin those of the lanes `which` whose distance is NaN.
template <class CoreOne, class CoreRow>
HWY_INLINE Number settled(const BodyRows& rows, const BlockPart& part, std::uint32_t which,
                          Number distance) {
  if (HWY_LIKELY(hn::AllTrue(Lanes(), hn::Eq(distance, distance)))) {
    return distance;
  }
  const std::uint32_t open = nansOf(distance) & which;
  return open != 0 ? finished<CoreOne, CoreRow>(rows, part, open, distance) : distance;
}

/// Correct in the lanes `which`, or NaN where the plain twin must decide. Clears lanes of `which`
/// that are found farther apart than `reach`.
template <class CoreOne, class CoreRow>
HWY_INLINE Number measureInKernel(const BodyRows& rows, const BlockPart& part, double reach,
                                  std::uint32_t& which) {
  Truth counts = truthOf(which);
  const Number distance = distanceWithin(coreOfOne<CoreOne>(rows, part),
                                         coreOfRow<CoreRow>(rows, part), number(reach), counts);
  which = bitsOf(counts);
  return distance;
}

/// Correct in the lanes `which`. Clears lanes of `which` that are farther apart than `reach`.
template <class CoreOne, class CoreRow>
HWY_INLINE Number measurePart(const BodyRows& rows, const BlockPart& part, double reach,
                              std::uint32_t& which) {
  const Number distance = measureInKernel<CoreOne, CoreRow>(rows, part, reach, which);
  return settled<CoreOne, CoreRow>(rows, part, which, distance);
}

/// Calls `take` with pair, lane and distance of each of the lanes `which`.
template <class Take>
HWY_INLINE void forLanes(const BlockPart& part, std::uint32_t which, Number distance,
                         const Take& take) {
  HWY_ALIGN double distances[kLanes];
  hn::Store(distance, Lanes(), distances);
  std::uint32_t pair = part.first_pair;
  for (std::uint32_t left = part.is_pair; left != 0; left &= left - 1) {
    const auto lane = static_cast<std::size_t>(__builtin_ctz(left));
    if ((which >> lane & 1U) != 0) {
      take(pair, lane, distances[lane]);
    }
    ++pair;
  }
}

/// Stores the values of all pairs of a part by PairId.
HWY_INLINE void storeByPair(const BlockPart& part, Number values, std::vector<double>& by_pair) {
  const auto first = static_cast<std::uint32_t>(__builtin_ctz(part.is_pair));
  const std::uint32_t in_row = part.is_pair >> first;
  const bool is_without_gap = (in_row & (in_row + 1)) == 0 && part.first_pair >= first &&
                              part.first_pair - first + kLanes <= by_pair.size();
  if (is_without_gap && first == 0) {
    // Values written beyond these pairs belong to later parts, which overwrite them.
    hn::StoreU(values, Lanes(), by_pair.data() + part.first_pair);
  } else if (is_without_gap) {
    hn::BlendedStore(values, truthOf(part.is_pair), Lanes(),
                     by_pair.data() + part.first_pair - first);
  } else {
    forLanes(part, part.is_pair, values,
             [&](std::uint32_t pair, std::size_t, double value)
                 HWY_ATTR { by_pair[pair] = value; });
  }
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#endif
