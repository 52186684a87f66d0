// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/broad_phase/pair_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace collision_monitor::test {
namespace {

/// Two of three pairs of the first bodies, in order of (a, b), of (b, a) or in none.
enum class PairOrder { by_a, by_b, none };

std::vector<BodyPair> somePairs(std::uint32_t bodies, PairOrder order) {
  std::vector<BodyPair> pairs;
  for (std::uint32_t a = 0; a < bodies; ++a) {
    for (std::uint32_t b = a + 1; b < bodies; ++b) {
      if ((a + b) % 3 != 0) {
        pairs.push_back({BodyId{a}, BodyId{b}});
      }
    }
  }
  if (order == PairOrder::by_b) {
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const BodyPair& one, const BodyPair& other) { return one.b < other.b; });
  } else if (order == PairOrder::none) {
    std::shuffle(pairs.begin(), pairs.end(), std::mt19937(20260101));
  }
  return pairs;
}

/// How many bodies the table says that there are decides how it looks pairs up.
class PairTableOfSize : public testing::TestWithParam<std::tuple<std::size_t, PairOrder>> {};

TEST_P(PairTableOfSize, findsEveryPairAndNoOther) {
  constexpr std::uint32_t kInPairs = 40;
  const auto [body_count, order] = GetParam();
  const PairTable table(somePairs(kInPairs, order), body_count);
  std::size_t found = 0;
  for (std::uint32_t one = 0; one < kInPairs; ++one) {
    for (std::uint32_t other = 0; other < kInPairs; ++other) {
      PairId id{kNone};
      if (table.find(BodyId{one}, BodyId{other}, id)) {
        ++found;
        EXPECT_EQ(table[id].a, BodyId{std::min(one, other)});
        EXPECT_EQ(table[id].b, BodyId{std::max(one, other)});
      } else {
        EXPECT_EQ(index(id), std::size_t{kNone}) << "stays as it was";
      }
    }
  }
  EXPECT_EQ(found, 2 * table.size());
}

INSTANTIATE_TEST_SUITE_P(Sizes, PairTableOfSize,
                         testing::Combine(testing::Values(40U, 5000U),
                                          testing::Values(PairOrder::by_a, PairOrder::by_b,
                                                          PairOrder::none)));

}  // namespace
}  // namespace collision_monitor::test
