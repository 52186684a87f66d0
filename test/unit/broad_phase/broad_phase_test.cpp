// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "broad_phase/broad_phase.h"

#include <gtest/gtest.h>

#include <limits>

#include "geometry/constants.h"

namespace collision_monitor {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

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

BodyBounds known(const std::vector<Aabb>& boxes) {
  return {boxes, std::vector<unsigned char>(boxes.size(), 1)};
}

std::vector<BodyPair> meetingsOf(BroadPhase& broad_phase, const BodyBounds& bounds) {
  std::vector<BodyPair> meetings;
  findMeetings(broad_phase, bounds, meetings);
  return meetings;
}

class EachBroadPhase : public testing::TestWithParam<BroadPhaseKind> {
 public:
  static std::vector<PairId> candidatesOf(const BodyBounds& bounds, const PairTable& table) {
    BroadPhase broad_phase = makeBroadPhase(GetParam(), bounds.boxes.size(), table.size());
    std::vector<PairId> candidates;
    findCandidates(broad_phase, bounds, table, candidates);
    return candidates;
  }
};

TEST_P(EachBroadPhase, onlyBoxesThatMeetAreCandidates) {
  const BodyBounds bounds = known({boxFrom(0, 1), boxFrom(0.5, 2), boxFrom(3, 4)});
  EXPECT_EQ(candidatesOf(bounds, allPairs(3)), std::vector<PairId>{PairId{0}});
}

TEST_P(EachBroadPhase, touchingBoxesMeet) {
  EXPECT_EQ(candidatesOf(known({boxFrom(1, 2), boxFrom(0, 1)}), allPairs(2)).size(), 1U);
}

TEST_P(EachBroadPhase, boxesApartOnAnotherAxisAreNoCandidates) {
  BodyBounds bounds = known({boxFrom(0, 1), boxFrom(0, 1)});
  bounds.boxes[1].min.z() = 1.5;
  bounds.boxes[1].max.z() = 2.5;
  EXPECT_TRUE(candidatesOf(bounds, allPairs(2)).empty());
}

TEST_P(EachBroadPhase, pairsOutsideTheTableAreNoCandidates) {
  const BodyBounds bounds = known({boxFrom(0, 1), boxFrom(0, 1), boxFrom(0, 1)});
  const PairTable table({{BodyId{1}, BodyId{2}}}, 3);
  EXPECT_EQ(candidatesOf(bounds, table), std::vector<PairId>{PairId{0}});
}

TEST_P(EachBroadPhase, candidatesAreSortedByIdWhateverTheOrderOfTheTable) {
  const BodyBounds bounds = known({boxFrom(0, 1), boxFrom(0, 1), boxFrom(0, 1)});
  const PairTable table({{BodyId{1}, BodyId{2}}, {BodyId{0}, BodyId{2}}, {BodyId{0}, BodyId{1}}},
                        3);
  EXPECT_EQ(candidatesOf(bounds, table), (std::vector<PairId>{PairId{0}, PairId{1}, PairId{2}}));
}

TEST_P(EachBroadPhase, unknownBodiesAreNoCandidates) {
  BodyBounds bounds = known({boxFrom(0, 1), boxFrom(0, 1), boxFrom(0, 1)});
  bounds.known[1] = 0;
  bounds.boxes[1].min.setConstant(kNan);
  EXPECT_EQ(candidatesOf(bounds, allPairs(3)), std::vector<PairId>{PairId{1}});
}

TEST_P(EachBroadPhase, boxesWithNanOrUpsideDownAreNone) {
  BodyBounds bounds = known({boxFrom(0, 1), boxFrom(0, 1), boxFrom(0, 1), boxFrom(1, 0)});
  bounds.boxes[1].max.y() = kNan;
  EXPECT_EQ(candidatesOf(bounds, allPairs(4)), std::vector<PairId>{PairId{1}});  // 0 and 2
}

TEST_P(EachBroadPhase, boxesWithoutEndMeetEverythingBetween) {
  BodyBounds bounds = known({boxFrom(0, 1), boxFrom(-kInfinity, kInfinity), boxFrom(1e300, 2e300)});
  EXPECT_EQ(candidatesOf(bounds, allPairs(3)), (std::vector<PairId>{PairId{0}, PairId{2}}));
}

TEST_P(EachBroadPhase, pairsFollowBodiesThatMoveAppearAndGo) {
  BroadPhase broad_phase = makeBroadPhase(GetParam(), 3);
  BodyBounds bounds = known({boxFrom(0, 1), boxFrom(2, 3), boxFrom(4, 5)});
  EXPECT_TRUE(meetingsOf(broad_phase, bounds).empty());
  bounds.boxes[1] = boxFrom(0.9, 1.9);
  const auto first = meetingsOf(broad_phase, bounds);
  ASSERT_EQ(first.size(), 1U);
  EXPECT_EQ(first[0].a, BodyId{0});
  EXPECT_EQ(first[0].b, BodyId{1});
  bounds.boxes[2] = boxFrom(-100, 100);
  EXPECT_EQ(meetingsOf(broad_phase, bounds).size(), 3U);
  bounds.known[0] = 0;
  EXPECT_EQ(meetingsOf(broad_phase, bounds).size(), 1U);
  bounds.known[0] = 1;
  bounds.boxes[1] = boxFrom(200, 201);
  EXPECT_EQ(meetingsOf(broad_phase, bounds).size(), 1U);
  bounds.known.assign(3, 0);
  EXPECT_TRUE(meetingsOf(broad_phase, bounds).empty());
}

TEST_P(EachBroadPhase, bodiesThatBecomeKnownOneAfterTheOther_meetTheirNeighbours) {
  for (const std::size_t count : {40U, 400U}) {
    BroadPhase broad_phase = makeBroadPhase(GetParam(), count);
    BodyBounds bounds = known(std::vector<Aabb>(count));
    bounds.known.assign(count, 0);
    for (std::size_t i = 0; i < count; ++i) {
      const auto start = static_cast<double>(i);
      bounds.boxes[i] = boxFrom(start, start + 1.0);
      bounds.known[i] = 1;
      ASSERT_EQ(meetingsOf(broad_phase, bounds).size(), i) << "of " << count;
    }
  }
}

TEST_P(EachBroadPhase, noBodiesGiveNoCandidates) {
  EXPECT_TRUE(candidatesOf(BodyBounds{}, PairTable()).empty());
}

constexpr const char* kNames[] = {"automatic", "bruteForce",    "sweepAndPrune", "hashedBins",
                                  "aabbTree",  "neighbourList", "combination"};

INSTANTIATE_TEST_SUITE_P(BroadPhase, EachBroadPhase,
                         testing::Values(BroadPhaseKind::automatic, BroadPhaseKind::brute_force,
                                         BroadPhaseKind::sweep_and_prune,
                                         BroadPhaseKind::hashed_bins, BroadPhaseKind::aabb_tree,
                                         BroadPhaseKind::neighbour_list,
                                         BroadPhaseKind::combination),
                         [](const testing::TestParamInfo<BroadPhaseKind>& which) {
                           return kNames[static_cast<std::size_t>(which.param)];
                         });

/// Tables of few bodies and of many are kept in different ways.
class EachPairTable : public testing::TestWithParam<std::size_t> {};

TEST_P(EachPairTable, findsAPairInEitherOrder) {
  const PairTable table({{BodyId{2}, BodyId{5}}, {BodyId{0}, BodyId{5}}}, GetParam());
  PairId pair{};
  ASSERT_TRUE(table.find(BodyId{5}, BodyId{0}, pair));
  EXPECT_EQ(pair, PairId{1});
  ASSERT_TRUE(table.find(BodyId{2}, BodyId{5}, pair));
  EXPECT_EQ(pair, PairId{0});
}

TEST_P(EachPairTable, missingPairLeavesIdAlone) {
  const PairTable table({{BodyId{0}, BodyId{1}}}, GetParam());
  PairId pair{7};
  EXPECT_FALSE(table.find(BodyId{0}, BodyId{2}, pair));
  EXPECT_FALSE(table.find(BodyId{2}, BodyId{1}, pair));
  EXPECT_EQ(pair, PairId{7});
}

INSTANTIATE_TEST_SUITE_P(PairTable, EachPairTable, testing::Values(6, 3000));

}  // namespace
}  // namespace collision_monitor
