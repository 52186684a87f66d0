// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstring>

#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/run_cycle.h"
#include "pipeline/data/activation_distance.h"
#include "pipeline/look_ahead/link_velocities.h"
#include "pipeline/states/check_states.h"
#include "support/allocation_guard.h"
#include "support/fixed_seed.h"
#include "support/query_meshes.h"
#include "support/robots/geometry_setup.h"
#include "support/robots/hand_made_setup.h"
#include "support/robots/ruled_setup.h"
#include "support/sample_meshes.h"

// Limits that rules give to pairs, held to set-ups where the same limits are those of all pairs.
namespace collision_monitor::test::pair_limits {
namespace {

/// 10 ms later: moves every link a little and now and then loses one.
void disturb(Random& random, LinkPoses& poses) {
  poses.stamp_ns += 10'000'000;
  for (std::size_t link = 0; link < poses.status.size(); ++link) {
    poses.world_from_link[link].translation += randomPoint(random, 0.04);
    poses.status[link] = random() % 50 == 0 ? LinkStatus::stale : LinkStatus::known;
  }
}

/// Cycles of one set-up on poses that are given from outside.
struct Cycles {
  explicit Cycles(const CycleSetup& its_setup)
      : setup(its_setup), buffers(makeBuffers(setup, BroadPhaseKind::automatic)) {}

  void run(const LinkPoses& poses) { runCycle(setup, poses, buffers); }

  CycleSetup setup;
  CycleBuffers buffers;
};

bool isSame(const PairDistance& one, const PairDistance& other) {
  return one.pair == other.pair && one.quality == other.quality &&
         one.is_refined == other.is_refined &&
         std::memcmp(&one.measured, &other.measured, sizeof one.measured) == 0 &&
         std::memcmp(&one.time_to_contact, &other.time_to_contact, sizeof(double)) == 0;
}

/// The distances that matter at rest. A cycle may keep others that fast links could reach, as many
/// as its boxes meet.
std::vector<PairDistance> nearPairs(const CycleBuffers& buffers, double within) {
  std::vector<PairDistance> near;
  for (const PairDistance& distance : buffers.distances.pairs) {
    if (distance.measured.distance <= within) {
      near.push_back(distance);
    }
  }
  return near;
}

void expectSame(const CycleBuffers& one, const CycleBuffers& other, double within) {
  const std::vector<PairDistance> near = nearPairs(one, within);
  const std::vector<PairDistance> others = nearPairs(other, within);
  ASSERT_EQ(near.size(), others.size());
  for (std::size_t i = 0; i < near.size(); ++i) {
    ASSERT_TRUE(isSame(near[i], others[i])) << i;
  }
  ASSERT_EQ(one.distances.passed.size(), other.distances.passed.size());
  ASSERT_EQ(one.events.verdicts, other.events.verdicts);
  ASSERT_EQ(one.events.changes.size(), other.events.changes.size());
  ASSERT_EQ(one.events.closest_of_all == kNone, other.events.closest_of_all == kNone);
  if (!near.empty()) {
    ASSERT_TRUE(isSame(one.distances.pairs[one.events.closest_of_all],
                       other.distances.pairs[other.events.closest_of_all]));
  }
  ASSERT_EQ(one.memory.speed.scale, other.memory.speed.scale);
}

/// Shapes, or meshes that cycles refine.
CycleSetup anySetup(int round) {
  if (round % 2 == 0) {
    return randomSetup(9, kSeed + static_cast<unsigned>(round));
  }
  return geometrySetup({scaled(angleMesh(), 0.5), boxMesh({0.05, 0.08, 0.03}), Cylinder{0.05, 0.1},
                        bumpyMesh(0.08, 8), Capsule{0.08, 0.03}},
                       SetupOptions());
}

TEST(PairLimitsLaws, aRuleForAllPairsEqualsTheSameCommonLimits) {
  std::size_t warnings = 0;
  std::size_t passed = 0;
  for (int round = 0; round < 12; ++round) {
    SCOPED_TRACE(testing::Message() << "round " << round);
    Random random(kSeed + static_cast<unsigned>(round));
    CycleSetup common = anySetup(round);
    common.is_continuous = true;
    CycleSetup ruled = common;
    common.limits = randomLimits(random);
    giveRules({ruleForAll(common.limits, ruled)}, ruled);
    ASSERT_EQ(ruled.own_limits.size(), 1U);
    Cycles by_common(common);
    Cycles by_rule(ruled);
    LinkPoses poses = randomLinkPoses(common, 0.3, kSeed);
    VelocityTracker tracker = makeVelocityTracker(common.model);
    for (int cycle = 0; cycle < 200; ++cycle) {
      disturb(random, poses);
      trackVelocities(common.model, VelocityOptions(), tracker, poses);
      by_common.run(poses);
      by_rule.run(poses);
      expectSame(by_common.buffers, by_rule.buffers, activationDistanceOf(common.limits));
      warnings += by_rule.buffers.events.overall == Verdict::warning ? 1 : 0;
      passed += by_rule.buffers.distances.passed.size();
    }
  }
  EXPECT_GT(warnings, 100U);
  EXPECT_GT(passed, 3U);
}

TEST(PairLimitsLaws, eachPairIsJudgedAsIfItsLimitsWereThoseOfAllPairs) {
  std::size_t differing = 0;
  for (int round = 0; round < 12; ++round) {
    SCOPED_TRACE(testing::Message() << "round " << round);
    Random random(kSeed + static_cast<unsigned>(round));
    CycleSetup ruled = randomSetup(9, kSeed + static_cast<unsigned>(round));
    giveRules({ruleForSome(randomLimits(random), ruled, random),
               ruleForSome(randomLimits(random), ruled, random)},
              ruled);
    std::vector<Cycles> by_common;
    for (std::size_t i = 0; i <= ruled.own_limits.size(); ++i) {
      CycleSetup setup = ruled;
      setup.limits = i == 0 ? ruled.limits : ruled.own_limits[i - 1].limits;
      giveRules({}, setup);
      by_common.emplace_back(setup);
    }
    Cycles by_rule(ruled);
    LinkPoses poses = randomLinkPoses(ruled, 0.3, kSeed);
    VelocityTracker tracker = makeVelocityTracker(ruled.model);
    for (int cycle = 0; cycle < 200; ++cycle) {
      disturb(random, poses);
      trackVelocities(ruled.model, VelocityOptions(), tracker, poses);
      by_rule.run(poses);
      for (Cycles& cycles : by_common) {
        cycles.run(poses);
      }
      for (std::size_t i = 0; i < ruled.checked.size(); ++i) {
        const Verdict verdict = by_rule.buffers.events.verdicts[i];
        const Cycles& wanted = by_common[ruled.checked[i].limits];
        ASSERT_EQ(verdict, wanted.buffers.events.verdicts[i]) << "cycle " << cycle << " pair " << i;
        differing += verdict != by_common[0].buffers.events.verdicts[i] ? 1 : 0;
      }
    }
  }
  EXPECT_GT(differing, 1000U) << "the limits are too much alike to prove anything";
}

TEST(PairLimitsLaws, cyclesAllocateNothing) {
  Random random(kSeed);
  CycleSetup setup = anySetup(1);
  setup.is_continuous = true;
  giveRules({ruleForSome(randomLimits(random), setup, random)}, setup);
  Cycles cycles(setup);
  LinkPoses poses = randomLinkPoses(setup, 0.3, kSeed);
  std::size_t allocations = 0;
  for (int cycle = 0; cycle < 500; ++cycle) {
    disturb(random, poses);
    const AllocationGuard guard;
    cycles.run(poses);
    allocations += guard.count();
  }
  EXPECT_EQ(allocations, 0U);
}

}  // namespace
}  // namespace collision_monitor::test::pair_limits
