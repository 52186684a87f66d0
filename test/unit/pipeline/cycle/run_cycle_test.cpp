// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/cycle/run_cycle.h"

#include <gtest/gtest.h>

#include <limits>

#include "collision_monitor/geometry/ids.h"
#include "pipeline/answers/carry_over.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/judge_pairs.h"
#include "support/robots/hand_made_setup.h"

namespace collision_monitor {
namespace {

using test::handMadeSetup;
using test::knownPoses;

/// Two balls of radius 0.1 m, each on a link of its own; limits 0 / 0.05 / 0.005 / 0.2 m.
class TwoBalls : public testing::Test {
 protected:
  CycleSetup setup_ = handMadeSetup({{0, Sphere{0.1}}, {1, Sphere{0.1}}});
  CycleBuffers buffers_ = makeBuffers(setup_, BroadPhaseKind::brute_force);
  LinkPoses poses_ = knownPoses(setup_);

  void runWithGap(double gap) {
    poses_.world_from_link[1].translation.x() = 0.2 + gap;
    runCycle(setup_, poses_, buffers_);
  }
  Verdict verdict() const { return buffers_.events.verdicts[0]; }
};

TEST_F(TwoBalls, apart_distancePointsAndNormalAreThoseOfTheSurfaces) {
  runWithGap(0.1);
  ASSERT_EQ(buffers_.distances.pairs.size(), 1U);
  const PairDistance& pair = buffers_.distances.pairs[0];
  EXPECT_EQ(pair.quality, Quality::exact);
  EXPECT_NEAR(pair.measured.distance, 0.1, 1e-15);
  EXPECT_TRUE(pair.measured.point_on_a.isApprox(Eigen::Vector3d(0.1, 0, 0), 1e-12));
  EXPECT_TRUE(pair.measured.point_on_b.isApprox(Eigen::Vector3d(0.2, 0, 0), 1e-12));
  EXPECT_TRUE(pair.measured.normal_a_to_b.isApprox(Eigen::Vector3d::UnitX(), 1e-12));
  EXPECT_EQ(verdict(), Verdict::clear);
  EXPECT_EQ(buffers_.events.overall, Verdict::clear);
}

TEST_F(TwoBalls, verdictFollowsTheDistance) {
  runWithGap(0.06);
  EXPECT_EQ(verdict(), Verdict::clear);
  runWithGap(0.04);
  EXPECT_EQ(verdict(), Verdict::warning);
  runWithGap(-0.01);
  EXPECT_EQ(verdict(), Verdict::contact);
  ASSERT_EQ(buffers_.events.changes.size(), 1U);
  EXPECT_EQ(buffers_.events.changes[0].before, Verdict::warning);
  EXPECT_EQ(buffers_.events.changes[0].after, Verdict::contact);
}

TEST_F(TwoBalls, verdictIsLeftOnlyBeyondTheHysteresis) {
  runWithGap(0.04);
  runWithGap(0.054);
  EXPECT_EQ(verdict(), Verdict::warning);
  EXPECT_TRUE(buffers_.events.changes.empty());
  runWithGap(0.056);
  EXPECT_EQ(verdict(), Verdict::clear);
  runWithGap(0.054);
  EXPECT_EQ(verdict(), Verdict::clear);
  runWithGap(0.0);
  runWithGap(0.004);
  EXPECT_EQ(verdict(), Verdict::contact);
  runWithGap(0.006);
  EXPECT_EQ(verdict(), Verdict::warning);
}

TEST_F(TwoBalls, outOfReach_closestIsMeasuredAllTheSame) {
  runWithGap(5.0);
  EXPECT_EQ(buffers_.counters.candidates, 0U);
  ASSERT_EQ(buffers_.events.closest_of_all, 0U);
  EXPECT_NEAR(buffers_.distances.pairs[0].measured.distance, 5.0, 1e-14);
}

TEST_F(TwoBalls, missingLink_pairIsUnknownAndNeverClear) {
  poses_.status[1] = LinkStatus::missing;
  runWithGap(1.0);
  EXPECT_EQ(verdict(), Verdict::unknown);
  EXPECT_EQ(buffers_.events.overall, Verdict::unknown);
  EXPECT_EQ(buffers_.events.closest_of_all, kNone);
  EXPECT_EQ(buffers_.counters.unknown_links, 1U);
  EXPECT_EQ(buffers_.counters.unknown_pairs, 1U);
  EXPECT_TRUE(buffers_.events.changes.empty()) << "a clear pair falls silent with its link";
}

TEST_F(TwoBalls, nanPoseCalledKnown_pairIsUnknown) {
  runWithGap(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(verdict(), Verdict::unknown);
}

TEST_F(TwoBalls, shearedRotationCalledKnown_pairIsUnknown) {
  poses_.world_from_link[0].rotation(0, 1) = 0.5;
  runWithGap(1.0);
  EXPECT_EQ(verdict(), Verdict::unknown);
}

TEST_F(TwoBalls, nearPairThatBecomesUnknown_isReportedAndComesBack) {
  runWithGap(0.01);
  poses_.status[0] = LinkStatus::stale;
  runWithGap(0.01);
  ASSERT_EQ(buffers_.events.changes.size(), 1U);
  EXPECT_EQ(buffers_.events.changes[0].after, Verdict::unknown);
  poses_.status[0] = LinkStatus::known;
  runWithGap(1.0);
  ASSERT_EQ(buffers_.events.changes.size(), 1U);
  EXPECT_EQ(buffers_.events.changes[0].before, Verdict::unknown);
  EXPECT_EQ(buffers_.events.changes[0].after, Verdict::clear);
}

TEST_F(TwoBalls, resetMemory_forgetsHysteresis) {
  runWithGap(0.04);
  resetMemory(buffers_);
  runWithGap(0.054);
  EXPECT_EQ(verdict(), Verdict::clear);
}

TEST_F(TwoBalls, forgetPoses_leavesWhatWasReportedToBeTakenBack) {
  runWithGap(-0.01);
  forgetPoses(buffers_);
  runWithGap(0.06);
  ASSERT_EQ(buffers_.events.changes.size(), 1U);
  EXPECT_EQ(buffers_.events.changes[0].before, Verdict::contact);
  EXPECT_EQ(buffers_.events.changes[0].after, Verdict::clear);
}

/// As a search on the way tells it that the budget ended: the hysteresis holds none of it.
TEST_F(TwoBalls, contactOnTheWayThatTheBudgetLeftOpen_isNotHeld) {
  runWithGap(0.002);
  const auto judge = [&] {
    judgePairs(setup_, buffers_.body_poses, poses_.velocities, buffers_.distances, buffers_.memory,
               buffers_.events);
    return verdict();
  };
  PassedContact passed;
  passed.distance = buffers_.distances.pairs[0];
  passed.distance.quality = Quality::lower_bound;
  buffers_.distances.passed = {passed};
  EXPECT_EQ(judge(), Verdict::contact);
  buffers_.distances.passed.clear();
  EXPECT_EQ(judge(), Verdict::warning);
  passed.distance.quality = Quality::exact;
  buffers_.distances.passed = {passed};
  EXPECT_EQ(judge(), Verdict::contact);
  buffers_.distances.passed.clear();
  EXPECT_EQ(judge(), Verdict::contact) << "one of the geometries is held";
}

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
  EXPECT_EQ(carryOver(from, reported, to, memory), std::vector<LinkPairIndex>{2});
  EXPECT_EQ(memory.reported, std::vector<Verdict>{Verdict::contact});
  EXPECT_EQ(memory.contact_detail[0], Detail::geometries);
  EXPECT_EQ(memory.speed.stopped[0], 1);
  EXPECT_EQ(memory.speed.scale, 0.25);
  EXPECT_EQ(memory.speed.stamp_ns, 7);
}

TEST(RunCycle, severalShapesPerLink_verdictIsThatOfTheNearest) {
  const Pose far{Eigen::Matrix3d::Identity(), Eigen::Vector3d(0, 0, 3)};
  const CycleSetup setup =
      handMadeSetup({{0, Sphere{0.1}}, {1, Capsule{0.1, 0.1}, far}, {1, Sphere{0.1}}});
  CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::brute_force);
  LinkPoses poses = knownPoses(setup);
  poses.world_from_link[1].translation.x() = 0.23;
  runCycle(setup, poses, buffers);
  ASSERT_EQ(buffers.events.verdicts.size(), 1U);
  EXPECT_EQ(buffers.events.verdicts[0], Verdict::warning);
  const PairDistance& closest = buffers.distances.pairs[buffers.events.closest[0]];
  EXPECT_EQ(setup.table[closest.pair].b, BodyId{2});
}

TEST(RunCycle, contactsFormIslands) {
  const CycleSetup setup = handMadeSetup(
      {{0, Sphere{1}}, {1, Sphere{1}}, {2, Sphere{1}}, {3, Sphere{1}}, {4, Sphere{1}}});
  CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::brute_force);
  LinkPoses poses = knownPoses(setup);
  const double x[] = {0.0, 10.0, 1.5, 11.5, 20.0};  // 0 touches 2, 1 touches 3, 4 is alone
  for (std::size_t link = 0; link < 5; ++link) {
    poses.world_from_link[link].translation.x() = x[link];
  }
  runCycle(setup, poses, buffers);
  EXPECT_EQ(buffers.events.island_count, 2U);
  EXPECT_EQ(buffers.events.island_of_link, (std::vector<std::uint32_t>{1, 2, 1, 2, 0}));
  poses.world_from_link[4].translation.x() = 5.5;  // joins nothing: 2 ends at 2.5, 1 starts at 9
  runCycle(setup, poses, buffers);
  EXPECT_EQ(buffers.events.island_count, 2U);
}

TEST(RunCycle, chainOfContactsIsOneIsland) {
  const CycleSetup setup = handMadeSetup({{0, Sphere{1}}, {1, Sphere{1}}, {2, Sphere{1}}});
  CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::sweep_and_prune);
  LinkPoses poses = knownPoses(setup);
  poses.world_from_link[0].translation.x() = 3.0;  // 1 - 2 - 0
  poses.world_from_link[2].translation.x() = 1.5;
  runCycle(setup, poses, buffers);
  EXPECT_EQ(buffers.events.island_of_link, (std::vector<std::uint32_t>{1, 1, 1}));
}

TEST(ListPairs, tableIsOrderedByKindOfCore) {
  const CycleSetup setup = handMadeSetup(
      {{0, Box{{1, 1, 1}}}, {1, Sphere{1}}, {2, Capsule{1, 1}}, {3, Sphere{1}}, {4, RoundedBox{}}});
  ASSERT_EQ(setup.ranges.size(),
            5U);  // point-point, point-segment, point-box, segment-box, box-box
  std::size_t next = 0;
  for (const PairRange& range : setup.ranges) {
    EXPECT_EQ(range.first, next);
    for (std::size_t i = range.first; i < range.last; ++i) {
      const BodyPair& pair = setup.table.pairs()[i];
      const CoreKind a = coreKindOf(setup.bodies[index(pair.a)].shape);
      const CoreKind b = coreKindOf(setup.bodies[index(pair.b)].shape);
      EXPECT_EQ(std::min(a, b), range.a);
      EXPECT_EQ(std::max(a, b), range.b);
    }
    next = range.last;
  }
  EXPECT_EQ(next, setup.table.size());
  EXPECT_EQ(next, 10U);
}

TEST(CheckLimits, everyFaultIsNamed) {
  SetupReport report;
  checkLimits({0.1, 0.05, -1.0, std::numeric_limits<double>::quiet_NaN()}, "limits/", report);
  ASSERT_EQ(report.errors.size(), 3U);
  EXPECT_EQ(report.errors[0].where, "limits/warning_distance");
  EXPECT_EQ(report.errors[1].where, "limits/report_distance");
  EXPECT_EQ(report.errors[2].where, "limits/hysteresis");
}

}  // namespace
}  // namespace collision_monitor
