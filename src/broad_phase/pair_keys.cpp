// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "broad_phase/pair_keys.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace collision_monitor {
namespace {

constexpr unsigned kMostDigitBits = 11;

/// One stable pass of counting sort.
void sortByDigit(BitRange digit, const std::vector<std::uint64_t>& keys,
                 std::vector<std::uint64_t>& sorted) noexcept {
  const std::uint64_t mask = (std::uint64_t{1} << digit.count) - 1;
  std::array<std::uint32_t, std::size_t{1} << kMostDigitBits> places;
  std::fill_n(places.begin(), mask + 1, 0U);
  for (const std::uint64_t key : keys) {
    ++places[(key >> digit.first) & mask];
  }
  std::uint32_t next = 0;
  for (std::size_t value = 0; value <= mask; ++value) {
    const std::uint32_t count = places[value];
    places[value] = next;
    next += count;
  }
  sorted.resize(keys.size());
  for (const std::uint64_t key : keys) {
    sorted[places[(key >> digit.first) & mask]++] = key;
  }
}

}  // namespace

std::size_t roomForPairs(std::size_t body_count) noexcept {
  constexpr std::size_t kAllPairsUpTo = 1000;
  constexpr std::size_t kPairsABody = 64;
  const std::size_t counted = std::min(body_count, kAllPairsUpTo);
  return std::max(counted * counted / 2, kPairsABody * (body_count - counted));
}

void radixSort(BitRange bits, std::vector<std::uint64_t>& keys,
               std::vector<std::uint64_t>& scratch) noexcept {
  constexpr std::size_t kFewKeys = 512;  // counters of long digits would cost more than the keys
  const unsigned digit_bits = keys.size() < kFewKeys ? 8 : kMostDigitBits;
  const unsigned passes = (bits.count + digit_bits - 1) / digit_bits;
  for (unsigned pass = 0; pass < passes; ++pass) {
    const unsigned first = bits.count * pass / passes;
    const unsigned last = bits.count * (pass + 1) / passes;
    sortByDigit({bits.first + first, last - first}, keys, scratch);
    keys.swap(scratch);
  }
}

void sortPairs(std::size_t body_count, std::vector<PairKey>& pairs,
               std::vector<PairKey>& scratch) noexcept {
  constexpr std::size_t kFewPairs = 32;
  if (std::is_sorted(pairs.begin(), pairs.end())) {
    return;
  }
  if (pairs.size() < kFewPairs) {
    std::sort(pairs.begin(), pairs.end());
    return;
  }
  unsigned body_bits = 1;
  while ((body_count - 1) >> body_bits != 0) {
    ++body_bits;
  }
  radixSort({0, body_bits}, pairs, scratch);
  radixSort({32, body_bits}, pairs, scratch);
}

std::uint32_t orderedBits(float coordinate) noexcept {
  constexpr std::uint32_t kSign = 0x80000000U;
  const float without_minus_zero = coordinate + 0.0F;
  std::uint32_t bits = 0;
  std::memcpy(&bits, &without_minus_zero, sizeof bits);
  return (bits & kSign) != 0 ? ~bits : bits | kSign;
}

}  // namespace collision_monitor
