// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/answers/carry_over.h"

#include <gtest/gtest.h>

#include <utility>

#include "pipeline/cycle/cycle_buffers.h"
#include "support/robots/hand_made_setup.h"

namespace collision_monitor::test {
namespace {

TEST(CarryOver, pairsOfTheSameLinks_keepWhatWasReportedAndOthersAreDropped) {
  const CycleSetup from = handMadeSetup({{0, Sphere{0.1}}, {1, Sphere{0.1}}, {2, Sphere{0.1}}});
  CycleSetup to = handMadeSetup({{0, Sphere{0.1}}, {1, Sphere{0.1}}});
  std::swap(to.model.links[0].frame, to.model.links[1].frame);
  PairMemory reported = makeBuffers(from, BroadPhaseKind::brute_force).memory;
  ASSERT_EQ(from.checked.size(), 3U);
  reported.reported = {Verdict::contact, Verdict::clear, Verdict::warning};
  reported.contact_detail[0] = Detail::geometries;
  reported.speed.stopped[0] = 1;
  reported.speed.scale = 0.25;
  reported.speed.stamp_ns = 7;
  PairMemory memory = makeBuffers(to, BroadPhaseKind::brute_force).memory;
  EXPECT_EQ(carryOver(planCarryOver(from, to), reported, memory), std::vector<LinkPairIndex>{2});
  EXPECT_EQ(memory.reported, std::vector<Verdict>{Verdict::contact});
  EXPECT_EQ(memory.contact_detail[0], Detail::geometries);
  EXPECT_EQ(memory.speed.stopped[0], 1);
  EXPECT_EQ(memory.speed.scale, 0.25);
  EXPECT_EQ(memory.speed.stamp_ns, 7);
}

TEST(CarryOver, pairThatIsNew_isAsNothingWereReported) {
  const CycleSetup from = handMadeSetup({{0, Sphere{0.1}}, {1, Sphere{0.1}}});
  const CycleSetup to = handMadeSetup({{0, Sphere{0.1}}, {1, Sphere{0.1}}, {2, Sphere{0.1}}});
  PairMemory reported = makeBuffers(from, BroadPhaseKind::brute_force).memory;
  reported.reported = {Verdict::unknown};
  PairMemory memory = makeBuffers(to, BroadPhaseKind::brute_force).memory;
  EXPECT_TRUE(carryOver(planCarryOver(from, to), reported, memory).empty());
  EXPECT_EQ(memory.reported,
            (std::vector<Verdict>{Verdict::unknown, Verdict::clear, Verdict::clear}));
}

TEST(CarryOver, clearPairThatIsNotCheckedAnyMore_isNoLoss) {
  const CycleSetup from = handMadeSetup({{0, Sphere{0.1}}, {1, Sphere{0.1}}, {2, Sphere{0.1}}});
  const CycleSetup to = handMadeSetup({{0, Sphere{0.1}}});
  ASSERT_TRUE(to.checked.empty());
  PairMemory reported = makeBuffers(from, BroadPhaseKind::brute_force).memory;
  PairMemory memory = makeBuffers(to, BroadPhaseKind::brute_force).memory;
  EXPECT_TRUE(carryOver(planCarryOver(from, to), reported, memory).empty());
  reported.reported[1] = Verdict::unknown;
  EXPECT_EQ(carryOver(planCarryOver(from, to), reported, memory), std::vector<LinkPairIndex>{1});
}

TEST(CarryOver, pairsThatRulesDropAndTakeBack_keepVerdictsOfTheOthers) {
  const CycleSetup all = handMadeSetup({{0, Sphere{0.1}}, {1, Sphere{0.1}}, {2, Sphere{0.1}}});
  const CycleSetup few = withPairs(all, {all.link_pairs[0], all.link_pairs[2]});
  PairMemory reported = makeBuffers(all, BroadPhaseKind::brute_force).memory;
  reported.reported = {Verdict::contact, Verdict::warning, Verdict::unknown};
  reported.contact_detail[0] = Detail::geometries;
  reported.speed.scale = 0.25;
  PairMemory memory = makeBuffers(few, BroadPhaseKind::brute_force).memory;
  EXPECT_EQ(carryOver(planCarryOver(all, few), reported, memory), std::vector<LinkPairIndex>{1});
  EXPECT_EQ(memory.reported, (std::vector<Verdict>{Verdict::contact, Verdict::unknown}));
  EXPECT_EQ(memory.contact_detail[0], Detail::geometries);
  EXPECT_EQ(memory.speed.scale, 0.25);
  PairMemory again = makeBuffers(all, BroadPhaseKind::brute_force).memory;
  EXPECT_TRUE(carryOver(planCarryOver(few, all), memory, again).empty());
  EXPECT_EQ(again.reported,
            (std::vector<Verdict>{Verdict::contact, Verdict::clear, Verdict::unknown}));
}

}  // namespace
}  // namespace collision_monitor::test
