// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace collision_monitor {

/// Two bodies in one number, the lower one in the upper half. Sorting the numbers sorts pairs by
/// (a, b).
using PairKey = std::uint64_t;

constexpr PairKey pairKey(std::uint32_t one, std::uint32_t other) noexcept {
  return one < other ? (PairKey{one} << 32) | other : (PairKey{other} << 32) | one;
}
constexpr std::uint32_t lowerBody(PairKey pair) noexcept {
  return static_cast<std::uint32_t>(pair >> 32);
}
constexpr std::uint32_t upperBody(PairKey pair) noexcept {
  return static_cast<std::uint32_t>(pair);
}

/// The number of meeting pairs for which set-up makes room. Up to 1,000 bodies that is all pairs,
/// so a robot's cycle never allocates in any pose. Beyond, it is 64 per body, and lists grow in
/// more crowded scenes.
std::size_t roomForPairs(std::size_t body_count) noexcept;

struct BitRange {
  unsigned first{0};
  unsigned count{0};
};

/// Sorts by `bits` alone and keeps the order of keys whose bits are equal. Takes the least
/// significant digit first, in digits of up to 11 bits, or 8 for few keys.
/// Source: Knuth, "The Art of Computer Programming" 3 (1998), section 5.2.5.
/// @pre `scratch` has room for as many keys; then nothing is allocated.
void radixSort(BitRange bits, std::vector<std::uint64_t>& keys,
               std::vector<std::uint64_t>& scratch) noexcept;

/// Sorts pairs of bodies below `body_count`. Costs one pass when they are already sorted.
void sortPairs(std::size_t body_count, std::vector<PairKey>& pairs,
               std::vector<PairKey>& scratch) noexcept;

/// A number in the order of the coordinate, minus infinity first. NaN is last if its sign is +.
std::uint32_t orderedBits(float coordinate) noexcept;

}  // namespace collision_monitor
