// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "collision_monitor/geometry/ids.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/run_cycle.h"
#include "pipeline/data/activation_distance.h"
#include "pipeline/look_ahead/link_velocities.h"
#include "support/allocation_guard.h"
#include "support/random_poses.h"
#include "support/robots/hand_made_setup.h"

namespace collision_monitor::parts_laws {
namespace {

using test::Random;

constexpr unsigned kSeed = 11;
constexpr std::size_t kLinks = 12;
/// Links from here on float, this one as their top.
constexpr std::size_t kTop = 6;

/// A set-up, and what a cycle does to it.
struct Watched {
  explicit Watched(const CycleSetup& setup)
      : buffers(makeBuffers(setup, BroadPhaseKind::automatic)),
        poses(test::knownPoses(setup)),
        tracker(makeVelocityTracker(setup.model)) {}

  void cycle(const CycleSetup& setup, const LinkPoses& now) {
    const LinkVelocities velocities = poses.velocities;
    poses = now;
    poses.velocities = velocities;
    const test::AllocationGuard guard;
    trackVelocities(setup.model, VelocityOptions(), tracker, poses);
    runCycle(setup, poses, buffers);
    allocations += guard.count();
  }

  CycleBuffers buffers;
  LinkPoses poses;
  VelocityTracker tracker;
  std::size_t allocations{0};
};

/// 10 ms later; now and then a link is gone.
void disturb(Random& random, LinkPoses& poses) {
  poses.stamp_ns += 10'000'000;
  poses.robot_stamp_ns[0] = poses.stamp_ns;
  for (std::size_t link = 0; link < kLinks; ++link) {
    if (link != kTop) {
      poses.world_from_link[link].translation += test::randomPoint(random, 0.03);
      if (random() % 100 == 0) {
        poses.world_from_link[link] = test::randomPose(random, 0.4);
      }
      poses.status[link] = random() % 50 == 0 ? LinkStatus::stale : LinkStatus::known;
    }
  }
}

LinkPoses withFloatingPart(const LinkPoses& poses) {
  LinkPoses split = poses;
  for (std::size_t link = kTop; link < kLinks; ++link) {
    split.part[link] = static_cast<PartId>(kTop);
    split.part_status[link] = LinkStatus::missing;
  }
  return split;
}

/// Links [first, last) are far away.
LinkPoses without(const LinkPoses& poses, std::size_t first, std::size_t last) {
  LinkPoses moved = poses;
  for (std::size_t link = first; link < last; ++link) {
    moved.world_from_link[link].translation.z() += 1000.0;
  }
  return moved;
}

bool isOfLinks(const CheckedLinkPair& pair, std::size_t first, std::size_t last) {
  return index(pair.a) >= first && index(pair.b) < last;
}

/// Everything within reach of pairs of links [first, last).
std::vector<PairDistance> distancesOf(const CycleSetup& setup, const CycleBuffers& buffers,
                                      std::size_t first, std::size_t last) {
  std::vector<PairDistance> found;
  for (const PairDistance& distance : buffers.distances.pairs) {
    const CheckedLinkPair& pair = setup.checked[setup.link_pair_of[index(distance.pair)]];
    if (isOfLinks(pair, first, last) &&
        distance.measured.distance <= activationDistanceOf(setup.limits)) {
      found.push_back(distance);
    }
  }
  return found;
}

std::size_t passedOf(const CycleSetup& setup, const CycleBuffers& buffers, std::size_t first,
                     std::size_t last) {
  std::size_t count = 0;
  for (const PassedContact& passed : buffers.distances.passed) {
    count += isOfLinks(setup.checked[setup.link_pair_of[index(passed.distance.pair)]], first, last)
                 ? 1
                 : 0;
  }
  return count;
}

void expectSame(const CycleSetup& setup, const CycleBuffers& split, const CycleBuffers& placed,
                std::size_t first, std::size_t last) {
  const auto one = distancesOf(setup, split, first, last);
  const auto other = distancesOf(setup, placed, first, last);
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    ASSERT_EQ(one[i].pair, other[i].pair);
    ASSERT_EQ(one[i].quality, other[i].quality);
    ASSERT_EQ(std::memcmp(&one[i].measured, &other[i].measured, sizeof one[i].measured), 0);
    ASSERT_EQ(std::memcmp(&one[i].closing_speed, &other[i].closing_speed, sizeof(double)), 0);
    ASSERT_EQ(std::memcmp(&one[i].time_to_contact, &other[i].time_to_contact, sizeof(double)), 0);
  }
  ASSERT_EQ(passedOf(setup, split, first, last), passedOf(setup, placed, first, last));
  for (std::size_t i = 0; i < setup.checked.size(); ++i) {
    if (isOfLinks(setup.checked[i], first, last)) {
      ASSERT_EQ(split.events.verdicts[i], placed.events.verdicts[i]);
    }
  }
}

TEST(PartsLaws, partThatFloatsIsJudgedAsOneAtTheOrigin_acrossNothingIsKnown) {
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  CycleSetup setup = test::randomSetup(kLinks, kSeed);
  setup.is_continuous = true;
  Watched split(setup);
  Watched floating_alone(setup);
  Watched standing_alone(setup);
  Random random(kSeed);
  LinkPoses poses = test::randomLinkPoses(setup, 0.4, kSeed);
  poses.world_from_link[kTop] = Pose();
  std::size_t contacts = 0;
  std::size_t passed = 0;
  for (int cycle = 0; cycle < 2000; ++cycle) {
    disturb(random, poses);
    split.cycle(setup, withFloatingPart(poses));
    floating_alone.cycle(setup, without(poses, 0, kTop));
    standing_alone.cycle(setup, without(poses, kTop, kLinks));
    expectSame(setup, split.buffers, floating_alone.buffers, kTop, kLinks);
    expectSame(setup, split.buffers, standing_alone.buffers, 0, kTop);
    for (std::size_t i = 0; i < setup.checked.size(); ++i) {
      const CheckedLinkPair& pair = setup.checked[i];
      if (index(pair.a) < kTop && index(pair.b) >= kTop) {
        ASSERT_EQ(split.buffers.events.verdicts[i], Verdict::unknown);
        ASSERT_EQ(split.buffers.events.closest[i], kNone);
      }
    }
    contacts += split.buffers.events.island_count;
    passed += split.buffers.distances.passed.size();
  }
  EXPECT_EQ(split.allocations, 0U);
  EXPECT_GT(contacts, 100U);
  EXPECT_GT(passed, 10U);
}

}  // namespace
}  // namespace collision_monitor::parts_laws
