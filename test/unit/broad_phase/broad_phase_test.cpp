// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/broad_phase/broad_phase.h"

#include <gtest/gtest.h>

namespace collision_monitor {
namespace {

Aabb boxFrom(double min_x, double max_x) {
  return {Eigen::Vector3d(min_x, 0.0, 0.0), Eigen::Vector3d(max_x, 1.0, 1.0)};
}

PairTable allPairs(std::uint32_t bodies) {
  std::vector<BodyPair> pairs;
  for (std::uint32_t a = 0; a < bodies; ++a) {
    for (std::uint32_t b = a + 1; b < bodies; ++b) {
      pairs.push_back({BodyId{a}, BodyId{b}});
    }
  }
  return PairTable(pairs, bodies);
}

std::vector<PairId> candidatesOf(BroadPhase broad_phase, const BodyBounds& bounds,
                                 const PairTable& table) {
  std::vector<PairId> candidates;
  candidates.reserve(table.size());
  findCandidates(broad_phase, bounds, table, candidates);
  return candidates;
}

class EachBroadPhase : public testing::TestWithParam<int> {
 public:
  static BroadPhase make(std::size_t bodies) {
    return GetParam() == 0 ? BroadPhase(BruteForce{}) : BroadPhase(SweepAndPrune(bodies));
  }
};

TEST_P(EachBroadPhase, onlyBoxesThatMeetAreCandidates) {
  const BodyBounds bounds{{boxFrom(0, 1), boxFrom(0.5, 2), boxFrom(3, 4)}, {1, 1, 1}};
  EXPECT_EQ(candidatesOf(make(3), bounds, allPairs(3)), std::vector<PairId>{PairId{0}});
}

TEST_P(EachBroadPhase, touchingBoxesMeet) {
  const BodyBounds bounds{{boxFrom(1, 2), boxFrom(0, 1)}, {1, 1}};
  EXPECT_EQ(candidatesOf(make(2), bounds, allPairs(2)).size(), 1U);
}

TEST_P(EachBroadPhase, boxesApartOnAnotherAxisAreNoCandidates) {
  BodyBounds bounds{{boxFrom(0, 1), boxFrom(0, 1)}, {1, 1}};
  bounds.boxes[1].min.z() = 1.5;
  bounds.boxes[1].max.z() = 2.5;
  EXPECT_TRUE(candidatesOf(make(2), bounds, allPairs(2)).empty());
}

TEST_P(EachBroadPhase, pairsOutsideTheTableAreNoCandidates) {
  const BodyBounds bounds{{boxFrom(0, 1), boxFrom(0, 1), boxFrom(0, 1)}, {1, 1, 1}};
  const PairTable table({{BodyId{1}, BodyId{2}}}, 3);
  EXPECT_EQ(candidatesOf(make(3), bounds, table), std::vector<PairId>{PairId{0}});
}

TEST_P(EachBroadPhase, unknownBodiesAreNoCandidates) {
  BodyBounds bounds{{boxFrom(0, 1), boxFrom(0, 1), boxFrom(0, 1)}, {1, 0, 1}};
  bounds.boxes[1].min.setConstant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(candidatesOf(make(3), bounds, allPairs(3)), std::vector<PairId>{PairId{1}});
}

TEST_P(EachBroadPhase, noBodiesGiveNoCandidates) {
  EXPECT_TRUE(candidatesOf(make(0), BodyBounds{}, PairTable()).empty());
}

INSTANTIATE_TEST_SUITE_P(BroadPhase, EachBroadPhase, testing::Values(0, 1),
                         [](const testing::TestParamInfo<int>& which) {
                           return which.param == 0 ? "bruteForce" : "sweepAndPrune";
                         });

TEST(PairTable, findsAPairInEitherOrder) {
  const PairTable table({{BodyId{2}, BodyId{5}}, {BodyId{0}, BodyId{5}}}, 6);
  PairId pair{};
  ASSERT_TRUE(table.find(BodyId{5}, BodyId{0}, pair));
  EXPECT_EQ(pair, PairId{1});
  ASSERT_TRUE(table.find(BodyId{2}, BodyId{5}, pair));
  EXPECT_EQ(pair, PairId{0});
}

TEST(PairTable, missingPairLeavesIdAlone) {
  const PairTable table({{BodyId{0}, BodyId{1}}}, 3);
  PairId pair{7};
  EXPECT_FALSE(table.find(BodyId{0}, BodyId{2}, pair));
  EXPECT_FALSE(table.find(BodyId{2}, BodyId{1}, pair));
  EXPECT_EQ(pair, PairId{7});
}

}  // namespace
}  // namespace collision_monitor
