// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "geometry/constants.h"
#include "pipeline/data/activation_distance.h"
#include "pipeline/data/motion_bound.h"
#include "pipeline/look_ahead/link_walk.h"
#include "pipeline/setup/setup_parts.h"
#include "support/fixed_seed.h"
#include "support/instruction_sets.h"
#include "support/random_poses.h"
#include "support/robots/hand_made_setup.h"

// The walk over pairs of links in lanes against one pair after the other.
namespace collision_monitor::test::link_walk_laws {
namespace {

/// Every fourth pair of links is left out, so that blocks have gaps.
CycleSetup setupWithGaps(unsigned seed) {
  CycleSetup setup = randomSetup(2 + seed % 25, seed);
  for (std::size_t i = seed % 4; i < setup.link_pairs.size(); i += 4) {
    setup.link_pairs[i].reason = PairReason::adjacent;
  }
  listPairs(setup);
  setup.is_continuous = seed % 3 != 0;
  return setup;
}

struct Scene {
  CycleSetup setup;
  LinkPoses poses;
  SweepWork sweep;
};

/// Links that have come by some centimetres and move; of every seventh that is not known.
Scene movingScene(unsigned seed) {
  Random random(seed);
  Scene scene{setupWithGaps(seed), {}, {}};
  scene.poses = randomLinkPoses(scene.setup, 2.0, seed);
  scene.sweep = makeSweepWork(scene.setup);
  scene.sweep.elapsed = 0.01;
  scene.sweep.last_elapsed = 0.02;
  for (std::size_t link = 0; link < scene.poses.world_from_link.size(); ++link) {
    scene.poses.velocities.known[link] = (link + seed) % 7 == 0 ? 0 : 1;
    scene.poses.velocities.of_link[link] = {randomPoint(random, 2.0), randomPoint(random, 2.0)};
    scene.sweep.has_motion[link] = scene.poses.velocities.known[link];
    scene.sweep.had_motion[link] = (link + seed) % 5 == 0 ? 0 : 1;
    for (ScrewMotion* motion : {&scene.sweep.link_motions[link], &scene.sweep.last_motions[link]}) {
      *motion = {randomPose(random, 2.0), randomPoint(random, 0.1), randomPoint(random, 0.1)};
    }
  }
  return scene;
}

Twist stepOf(const ScrewMotion& motion) {
  return twistAbout(motion.start.translation, motion.travel, motion.turn);
}

double travelOf(const Twist& seen, const Eigen::Vector3d& center, double radius) {
  return velocityAt(seen, center).norm() + seen.angular.norm() * radius;
}

/// What lies ahead and behind; nothing is refined, warned of or reported.
/// @param time [s] how far is looked ahead
double plainReach(const Scene& scene, const CheckedLinkPair& pair, double time,
                  const std::vector<Ball>& balls) {
  const std::size_t a = index(pair.a);
  const std::size_t b = index(pair.b);
  const LinkVelocities& velocities = scene.poses.velocities;
  const bool is_known = velocities.known[a] != 0 && velocities.known[b] != 0;
  const double speed =
      is_known ? travelOf(velocities.of_link[b] - velocities.of_link[a],
                          scene.poses.world_from_link[b] * balls[b].center, balls[b].radius)
               : 0.0;
  const auto came = [&](std::size_t link) {
    const ScrewMotion& motion = scene.sweep.link_motions[link];
    return velocityAt(motion, balls[link].center).norm() + motion.turn.norm() * balls[link].radius;
  };
  const double stop = scene.setup.ahead.stop.stop_distance + scene.setup.limits.hysteresis;
  const double asked = std::max(scene.setup.limits.contact_distance, stop) + time * speed;
  const double travel = scene.setup.is_continuous ? came(a) + came(b) : 0.0;
  return std::max(asked, scene.setup.limits.contact_distance + travel);
}

/// The largest way of a pair for its thickness, of twists by LinkId.
double plainShare(const Scene& scene, const std::vector<Twist>& twists) {
  const std::vector<Ball> balls = linkBalls(scene.setup);
  const std::vector<double> thickness = thicknessOfPairs(scene.setup);
  double most = 0.0;
  for (std::size_t i = 0; i < scene.setup.checked.size(); ++i) {
    const std::size_t a = index(scene.setup.checked[i].a);
    const std::size_t b = index(scene.setup.checked[i].b);
    const Eigen::Vector3d center = scene.sweep.link_motions[b].start * balls[b].center;
    most = std::max(most, travelOf(twists[b] - twists[a], center, balls[b].radius) / thickness[i]);
  }
  return most;
}

void expectStep(const Scene& scene, const StepLimit& step) {
  std::vector<Twist> moved(scene.sweep.link_motions.size());
  std::vector<Twist> bent(moved.size());
  for (std::size_t link = 0; link < moved.size(); ++link) {
    moved[link] =
        scene.sweep.has_motion[link] != 0 ? stepOf(scene.sweep.link_motions[link]) : Twist();
    if (scene.sweep.has_motion[link] != 0 && scene.sweep.had_motion[link] != 0) {
      bent[link] = 0.125 * (moved[link] - 0.5 * stepOf(scene.sweep.last_motions[link]));
    }
  }
  EXPECT_NEAR(scene.sweep.elapsed / step.at_poses.longest, plainShare(scene, moved), 1e-9);
  const double on_way = scene.sweep.elapsed / step.on_way.longest;
  if (scene.setup.is_continuous) {
    EXPECT_NEAR(on_way * on_way, plainShare(scene, bent), 1e-9);
  } else {
    EXPECT_EQ(step.on_way.longest, step.at_poses.longest);
  }
}

void expectReach(double reach, double expected) {
  EXPECT_TRUE(reach == expected || std::abs(reach - expected) < 1e-12)
      << reach << " for " << expected;
}

/// In every third scene nothing is expected; else a contact before the horizon, a smaller scale.
LeastOfPairs expectedIn(const Scene& scene, Random& random) {
  LeastOfPairs expected;
  if (random() % 3 != 0) {
    expected.distance = uniform(random, -0.1, 0.3);
    expected.time = uniform(random, 0.0, 2.0 * scene.setup.ahead.horizon);
    expected.scale = uniform(random, 0.0, 1.0);
  }
  return expected;
}

/// Whatever touches later, asks for a larger scale or is farther says less than is expected.
double timeWatched(const Scene& scene, const LeastOfPairs& expected) {
  const double of_scale = expected.scale * scene.setup.ahead.stop.stop_time;
  const Limits& limits = scene.setup.limits;
  const double of_verdicts =
      limits.warning_time > 0.0 ? limits.warning_time + limits.time_hysteresis : 0.0;
  return std::min(scene.setup.ahead.horizon, std::max({expected.time, of_scale, of_verdicts}));
}

TEST(LinkWalkLaws, reachesAndStepsAreThoseOfEveryPairAlone_onEveryInstructionSet) {
  Random random(kSeed);
  for (unsigned seed = kSeed; seed < kSeed + 100; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Scene scene = movingScene(seed);
    const std::vector<Ball> balls = linkBalls(scene.setup);
    RobotSpeeds robots = makeRobotSpeeds(scene.setup.model);
    const LeastOfPairs expected = expectedIn(scene, random);
    std::fill(robots.expected.begin(), robots.expected.end(), expected);
    const double report = activationDistanceOf(scene.setup.limits);
    std::vector<double> first;
    for (const std::int64_t target : instructionSets()) {
      SCOPED_TRACE(hwy::TargetName(target));
      const OnlyInstructionSet only(target);
      ActivationDistances reaches = makeActivationDistances(scene.setup);
      findActivationDistances(scene.setup, scene.poses, robots, scene.sweep, reaches);
      ASSERT_EQ(reaches.motion.size(), scene.setup.checked.size());
      for (std::size_t i = 0; i < reaches.motion.size(); ++i) {
        expectReach(reaches.motion[i],
                    plainReach(scene, scene.setup.checked[i], timeWatched(scene, expected), balls));
        EXPECT_EQ(reaches.told[i], std::min(report, expected.distance));
      }
      ASSERT_TRUE(first.empty() || std::memcmp(first.data(), reaches.motion.data(),
                                               first.size() * sizeof(double)) == 0);
      first = reaches.motion;
      expectStep(scene, scene.sweep.step);
    }
  }
}

}  // namespace
}  // namespace collision_monitor::test::link_walk_laws
