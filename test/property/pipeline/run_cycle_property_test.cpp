// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "collision_monitor/geometry/ids.h"
#include "narrow_phase/distance.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/distance_cache.h"
#include "pipeline/cycle/judge_pairs.h"
#include "pipeline/cycle/measure_pairs.h"
#include "pipeline/cycle/run_cycle.h"
#include "pipeline/cycle/scale_speed.h"
#include "pipeline/look_ahead/find_closings.h"
#include "pipeline/look_ahead/link_velocities.h"
#include "support/allocation_guard.h"
#include "support/random_poses.h"
#include "support/robots/hand_made_setup.h"

namespace collision_monitor::run_cycle_laws {
namespace {

using test::Random;

constexpr unsigned kSeed = 7;

/// 10 ms later: moves every link a little and now and then takes one away or gives it NaN.
void disturb(Random& random, LinkPoses& poses) {
  poses.stamp_ns += 10'000'000;
  poses.robot_stamp_ns[0] = poses.stamp_ns;
  for (std::size_t link = 0; link < poses.status.size(); ++link) {
    Pose& pose = poses.world_from_link[link];
    if (!isFinite(pose)) {
      pose = test::randomPose(random, 0.4);
    }
    pose.translation += test::randomPoint(random, 0.02);
    poses.status[link] = random() % 50 == 0 ? LinkStatus::stale : LinkStatus::known;
    if (random() % 200 == 0) {
      pose.translation.y() = std::numeric_limits<double>::quiet_NaN();
    }
  }
}

bool sameBytes(const PairDistance& one, const PairDistance& other) {
  return one.pair == other.pair && one.quality == other.quality &&
         std::memcmp(&one.measured, &other.measured, sizeof one.measured) == 0 &&
         std::memcmp(&one.closing_speed, &other.closing_speed, sizeof(double)) == 0 &&
         std::memcmp(&one.time_to_contact, &other.time_to_contact, sizeof(double)) == 0;
}

void expectSameBytes(const CycleBuffers& one, const CycleBuffers& other) {
  ASSERT_EQ(one.distances.pairs.size(), other.distances.pairs.size());
  for (std::size_t i = 0; i < one.distances.pairs.size(); ++i) {
    ASSERT_TRUE(sameBytes(one.distances.pairs[i], other.distances.pairs[i]));
  }
  ASSERT_EQ(one.distances.passed.size(), other.distances.passed.size());
  for (std::size_t i = 0; i < one.distances.passed.size(); ++i) {
    ASSERT_TRUE(sameBytes(one.distances.passed[i].distance, other.distances.passed[i].distance));
    ASSERT_EQ(one.distances.passed[i].time, other.distances.passed[i].time);
  }
  ASSERT_EQ(one.events.passed, other.events.passed);
  ASSERT_EQ(one.events.verdicts, other.events.verdicts);
  ASSERT_EQ(one.events.closest, other.events.closest);
  ASSERT_EQ(one.events.changes.size(), other.events.changes.size());
  ASSERT_EQ(one.events.island_of_link, other.events.island_of_link);
  ASSERT_EQ(one.events.closest_of_all, other.events.closest_of_all);
  ASSERT_EQ(one.events.soonest, other.events.soonest);
  ASSERT_EQ(one.memory.speed.scale, other.memory.speed.scale);
}

std::vector<CycleBuffers> buffersFor(const CycleSetup& setup,
                                     const std::vector<BroadPhaseKind>& kinds) {
  std::vector<CycleBuffers> buffers;
  for (const BroadPhaseKind kind : kinds) {
    buffers.push_back(makeBuffers(setup, kind));
  }
  return buffers;
}

/// What happens in many cycles, so that they are known to prove something.
struct Events {
  std::size_t contacts{0};
  std::size_t passed{0};
  std::size_t slowed{0};

  void add(const CycleBuffers& buffers) {
    contacts += buffers.events.island_count;
    passed += buffers.distances.passed.size();
    slowed += buffers.memory.speed.scale < 1.0 ? 1 : 0;
  }
};

TEST(RunCycleProperty, tenThousandCyclesAllocateNothingAndEveryBroadPhaseGivesTheSameBytes) {
  CycleSetup setup = test::randomSetup(14, kSeed);
  setup.is_continuous = true;
  CycleBuffers brute_force = makeBuffers(setup, BroadPhaseKind::brute_force);
  std::vector<CycleBuffers> others =
      buffersFor(setup, {BroadPhaseKind::automatic, BroadPhaseKind::sweep_and_prune,
                         BroadPhaseKind::hashed_bins, BroadPhaseKind::aabb_tree,
                         BroadPhaseKind::neighbour_list, BroadPhaseKind::combination});
  std::size_t culled = 0;
  LinkPoses poses = test::randomLinkPoses(setup, 0.4, kSeed);
  VelocityTracker tracker = makeVelocityTracker(setup.model);
  Random random(kSeed);
  std::size_t allocations = 0;
  Events events;
  for (int cycle = 0; cycle < 10000; ++cycle) {
    disturb(random, poses);
    {
      const test::AllocationGuard guard;
      trackVelocities(setup.model, VelocityOptions(), tracker, poses);
      runCycle(setup, poses, brute_force);
      for (CycleBuffers& other : others) {
        runCycle(setup, poses, other);
      }
      allocations += guard.count();
    }
    for (const CycleBuffers& other : others) {
      expectSameBytes(brute_force, other);
      ASSERT_EQ(brute_force.counters.candidates, other.counters.candidates);
    }
    culled += others.back().counters.culled_by_boxes;
    events.add(brute_force);
  }
  EXPECT_EQ(allocations, 0U);
  EXPECT_GT(culled, 1000U) << "the combined run culls too little to prove anything";
  EXPECT_GT(events.contacts, 1000U) << "the scenes are too sparse to prove anything";
  EXPECT_GT(events.slowed, 1000U) << "nothing closes";
  EXPECT_GT(events.passed, 10U) << "links move too little to pass each other";
}

/// Every pair of known bodies.
std::vector<PairId> knownPairs(const CycleSetup& setup, const BodyPoses& body_poses) {
  std::vector<PairId> pairs;
  for (std::size_t i = 0; i < setup.table.size(); ++i) {
    const BodyPair& pair = setup.table.pairs()[i];
    if (body_poses.known[index(pair.a)] != 0 && body_poses.known[index(pair.b)] != 0) {
      pairs.push_back(idAt<PairId>(i));
    }
  }
  return pairs;
}

TEST(RunCycleProperty, whatIsCulledMattersToNoVerdictTimeOrScale) {
  CycleSetup setup = test::randomSetup(10, kSeed);
  setup.ahead.stop.release_time = 1e-9;  // what is asked for shows at once
  CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::brute_force);
  PairEvents events = buffers.events;
  LinkPoses poses = test::randomLinkPoses(setup, 1.0, kSeed);
  VelocityTracker tracker = makeVelocityTracker(setup.model);
  Random random(kSeed);
  std::size_t culled = 0;
  std::size_t soon = 0;
  std::size_t slowed = 0;
  for (int cycle = 0; cycle < 3000; ++cycle) {
    disturb(random, poses);
    trackVelocities(setup.model, VelocityOptions(), tracker, poses);
    PairMemory memory;
    memory.reported = buffers.memory.reported;
    memory.contact_detail = buffers.memory.contact_detail;
    memory.speed = buffers.memory.speed;
    RobotSpeeds robots = buffers.robots;
    runCycle(setup, poses, buffers);
    PairDistances all;
    measurePairs(setup, buffers.body_poses, knownPairs(setup, buffers.body_poses), all);
    findClosings(setup, poses, all);
    judgePairs(setup, buffers.body_poses, poses.velocities, all, memory, events);
    scaleSpeed(setup, poses.stamp_ns, all, events, memory.reported, memory.speed, robots);
    ASSERT_EQ(buffers.events.verdicts, events.verdicts);
    ASSERT_EQ(buffers.memory.speed.scale, memory.speed.scale);
    ASSERT_EQ(buffers.robots.scales, robots.scales);
    if (events.time_to_contact < std::numeric_limits<double>::infinity()) {
      ASSERT_EQ(buffers.events.time_to_contact, events.time_to_contact);
      ++soon;
    } else {
      ASSERT_EQ(std::isnan(buffers.events.time_to_contact), std::isnan(events.time_to_contact));
    }
    culled += buffers.counters.culled_by_spheres;
    slowed += memory.speed.scale < 1.0 ? 1 : 0;
  }
  EXPECT_GT(culled, 1000U);
  EXPECT_GT(soon, 1000U);
  EXPECT_GT(slowed, 1000U);
}

/// Small steps, so that what was measured once holds for many cycles: every second link drifts,
/// the others spin where they are. Now and then a link jumps.
void drift(Random& random, LinkPoses& poses) {
  poses.stamp_ns += 10'000'000;
  poses.robot_stamp_ns[0] = poses.stamp_ns;
  const Eigen::Matrix3d spin =
      Eigen::AngleAxisd(2e-3, Eigen::Vector3d(2.0, 3.0, 6.0) / 7.0).toRotationMatrix();
  for (std::size_t link = 0; link < poses.world_from_link.size(); ++link) {
    Pose& pose = poses.world_from_link[link];
    if (random() % 1000 == 0) {
      pose = test::randomPose(random, 0.6);
    }
    if (link % 2 == 0) {
      pose.translation += test::randomPoint(random, 2e-4);
    } else {
      pose.rotation = spin * pose.rotation;
    }
  }
}

/// Every two links' bodies are taken for those of two elements.
void joinElements(CycleSetup& setup) {
  std::vector<ElementPairIndex> first(setup.checked.size(), kNone);
  for (std::size_t i = 0; i < setup.table.size(); ++i) {
    ElementPairIndex& of_links = first[setup.link_pair_of[i]];
    of_links = std::min(of_links, setup.element_pair_of[i]);
    setup.element_pair_of[i] = of_links;
  }
}

TEST(RunCycleProperty, whatIsRememberedOfDistancesChangesNoByte) {
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  CycleSetup setup = test::randomSetup(12, kSeed);
  setup.is_continuous = true;
  joinElements(setup);
  CycleBuffers forgetful = makeBuffers(setup, BroadPhaseKind::brute_force);
  std::vector<CycleBuffers> others = buffersFor(
      setup,
      {BroadPhaseKind::brute_force, BroadPhaseKind::neighbour_list, BroadPhaseKind::combination});
  LinkPoses poses = test::randomLinkPoses(setup, 0.6, kSeed);
  VelocityTracker tracker = makeVelocityTracker(setup.model);
  Random random(kSeed);
  std::size_t culled = 0;
  std::size_t measured = 0;
  std::size_t told = 0;
  for (int cycle = 0; cycle < 5000; ++cycle) {
    drift(random, poses);
    trackVelocities(setup.model, VelocityOptions(), tracker, poses);
    forgetful.memory.distance_cache = makeDistanceCache(setup);
    runCycle(setup, poses, forgetful);
    for (CycleBuffers& other : others) {
      runCycle(setup, poses, other);
      expectSameBytes(forgetful, other);
    }
    culled += others[0].counters.culled_by_cache;
    measured += others[0].candidates.size();
    told += others[0].distances.pairs.size();
  }
  EXPECT_GT(culled, measured) << "too little is remembered to prove anything";
  EXPECT_GT(told, 10000U);
}

TEST(AllocationGuard, seesAnAllocation) {
  const test::AllocationGuard guard;
  std::vector<int> allocated(10);
  EXPECT_EQ(allocated.size(), 10U);
  EXPECT_GT(guard.count(), 0U);
}

/// What a cycle must find, the slow way: every pair measured.
double leastDistance(const CycleSetup& setup, const LinkPoses& poses, std::size_t link_pair) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < setup.table.size(); ++i) {
    const Body& a = setup.bodies[index(setup.table.pairs()[i].a)];
    const Body& b = setup.bodies[index(setup.table.pairs()[i].b)];
    if (setup.link_pair_of[i] == link_pair) {
      const auto measured =
          distanceBetween(a.shape, poses.world_from_link[index(a.link)] * a.link_from_body, b.shape,
                          poses.world_from_link[index(b.link)] * b.link_from_body);
      least = std::min(least, measured.distance);
    }
  }
  return least;
}

TEST(RunCycleProperty, verdictsAndClosestAreThoseOfMeasuringEveryPair) {
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  const CycleSetup setup = test::randomSetup(10, kSeed);
  CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::sweep_and_prune);
  for (unsigned round = 0; round < 500; ++round) {
    const double reach = round % 2 == 0 ? 0.6 : 6.0;  // crowded, then all out of reach
    const LinkPoses poses = test::randomLinkPoses(setup, reach, kSeed + round);
    resetMemory(buffers);
    runCycle(setup, poses, buffers);
    double least_of_all = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < setup.checked.size(); ++i) {
      const double least = leastDistance(setup, poses, i);
      least_of_all = std::min(least_of_all, least);
      const Verdict expected = least <= setup.limits.contact_distance   ? Verdict::contact
                               : least <= setup.limits.warning_distance ? Verdict::warning
                                                                        : Verdict::clear;
      ASSERT_EQ(buffers.events.verdicts[i], expected) << "distance " << least;
    }
    ASSERT_NE(buffers.events.closest_of_all, kNone);
    EXPECT_NEAR(buffers.distances.pairs[buffers.events.closest_of_all].measured.distance,
                least_of_all, 1e-12);
  }
}

}  // namespace
}  // namespace collision_monitor::run_cycle_laws
