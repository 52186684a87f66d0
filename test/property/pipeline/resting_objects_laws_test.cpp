// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <vector>

#include "geometry/constants.h"
#include "model/object_links.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/run_cycle.h"
#include "pipeline/data/activation_distance.h"
#include "pipeline/look_ahead/link_velocities.h"
#include "pipeline/objects/carry_objects.h"
#include "pipeline/world/add_world.h"
#include "support/allocation_guard.h"
#include "support/random_poses.h"
#include "support/robots/hand_made_setup.h"
#include "support/robots/world_objects.h"
#include "support/sanitizer.h"

/// A cycle leaves out objects that rest and pairs that are quiet. It must tell what a cycle tells
/// that looks at everything.
namespace collision_monitor::resting_objects_laws {
namespace {

using test::Random;

constexpr std::size_t kLinks = 6;
constexpr int kCycles = 100;

/// Boxes about the robot, most of them carried by "map", some by the frame "cart", and some held.
World crowdedWorld(std::size_t count, Random& random) {
  KnownPlaces places;
  for (std::size_t i = 0; i < kLinks; ++i) {
    places.links.push_back("link_" + std::to_string(i));
  }
  places.link_frames = places.links;
  places.world_frame = "map";
  places.has_frame = [](const std::string& frame) { return frame == "cart"; };
  std::vector<WorldObject> objects;
  for (std::size_t i = 0; i < count; ++i) {
    const double size = 0.01 + 0.01 * static_cast<double>(random() % 4);
    WorldObject object =
        test::objectOf("object_" + std::to_string(i), Box{{size, size, 2.0 * size}},
                       test::randomPose(random, 1.5));
    const std::uint64_t carrier = random() % 10;  // more than 64 each
    object.frame = carrier < 6 ? "cart" : "map";
    objects.push_back(carrier > 2 ? object : test::attached(object, "link_2"));
  }
  return test::worldOf(objects, places);
}

/// One monitor. The complete one places everything and judges every pair in each cycle.
struct Monitor {
  Monitor(CycleSetup made, bool looks_at_all, bool all_seem_to_rest,
          BroadPhaseKind kind = BroadPhaseKind::automatic)
      : setup(std::move(made)),
        is_complete(looks_at_all),
        seem_to_rest(all_seem_to_rest),
        objects(objectRuns(setup.model)) {
    if (is_complete) {
      setup.carried.clear();
    }
    buffers = makeBuffers(setup, kind);
    tracker = makeVelocityTracker(setup.model);
  }

  void cycle(LinkPoses poses) {
    carryPoses(setup.model, objects, poses);
    if (seem_to_rest) {
      std::fill(poses.velocities.known.begin(), poses.velocities.known.end(), 1);
    } else {
      trackVelocities(setup.model, {}, tracker, poses);
    }
    buffers.memory.judges_all = buffers.memory.judges_all || is_complete;
    const test::AllocationGuard guard;
    runCycle(setup, poses, buffers);
    allocations += guard.count();
  }

  CycleSetup setup;
  bool is_complete;
  bool seem_to_rest;  ///< velocities say so: then nothing is near for what lies ahead
  std::vector<ObjectRun> objects;
  CycleBuffers buffers;
  VelocityTracker tracker;
  std::size_t allocations{0};
};

/// Moves links and frames now and then, and loses some. Slow motion is such that lists of near
/// pairs serve for some cycles.
class Motion {
 public:
  Motion(const RobotModel& model, unsigned seed, bool is_slow)
      : model_(model), is_slow_(is_slow), random_(seed), poses_(makeLinkPoses(model)) {
    std::fill(poses_.status.begin(), poses_.status.end(), LinkStatus::known);
    for (std::size_t i = 0; i < kLinks; ++i) {
      poses_.world_from_link[i] = test::randomPose(random_, 0.7);
    }
  }

  const LinkPoses& next() {
    // A leap at the same stamp gives no velocity.
    leaps_ = !is_cart_moving_ && random_() % (is_slow_ ? 100 : 6) == 0;
    poses_.stamp_ns += leaps_ || random_() % 8 == 0 ? 0 : 10'000'000;
    std::fill(poses_.robot_stamp_ns.begin(), poses_.robot_stamp_ns.end(), poses_.stamp_ns);
    is_cart_moving_ = random_() % 12 == 0 ? !is_cart_moving_ : is_cart_moving_;
    for (const Robot& robot : model_.robots) {
      forOwnLinks(model_, robot, [&](std::size_t link) { move(link); });
    }
    return poses_;
  }

 private:
  struct Step {
    Eigen::Vector3d axis{Eigen::Vector3d::UnitX()};
    Eigen::Vector3d way{Eigen::Vector3d::Zero()};  // [m]
  };

  void move(std::size_t link) {
    const bool is_map = model_.links[link].name == "map";
    const bool is_cart = model_.links[link].name == "cart";
    const bool moves = is_cart ? is_cart_moving_ : !is_map;
    if (is_cart && leaps_) {
      poses_.world_from_link[link].translation += test::randomPoint(random_, 0.2);
    }
    if (moves && random_() % 4 > 0) {
      Step& step = steps_[link];
      if (!is_slow_ || random_() % 50 == 0) {
        step = {test::randomPoint(random_, 1.0).normalized(), test::randomPoint(random_, 0.01)};
      }
      const double pace = is_slow_ ? 0.08 : 1.0;
      const Eigen::AngleAxisd turn(0.03 * pace, step.axis);
      poses_.world_from_link[link] =
          poses_.world_from_link[link] * Pose{turn.toRotationMatrix(), pace * step.way};
    }
    const std::uint64_t fate = random_() % (is_slow_ ? 2400 : 120);
    if (fate < 2) {
      poses_.status[link] = fate == 0 ? LinkStatus::known : LinkStatus::stale;
    } else if (fate < 12) {
      poses_.status[link] = LinkStatus::known;
    }
  }

  const RobotModel& model_;
  bool is_slow_;
  Random random_;
  LinkPoses poses_;
  std::map<std::size_t, Step> steps_;
  bool is_cart_moving_{false};
  bool leaps_{false};
};

/// [m] Of the closest bodies; infinity if there are none within `farthest`. Farther pairs may be
/// left out: which are, follows from the boxes that each monitor has.
double distanceAt(const Monitor& monitor, std::uint32_t place, double farthest) {
  const double distance =
      place == kNone ? kInfinity : monitor.buffers.distances.pairs[place].measured.distance;
  return distance <= farthest ? distance : kInfinity;
}

void expectSame(const Monitor& sparse, const Monitor& complete) {
  const PairEvents& one = sparse.buffers.events;
  const PairEvents& other = complete.buffers.events;
  EXPECT_EQ(sparse.allocations, 0U);
  EXPECT_EQ(one.verdicts, other.verdicts);
  EXPECT_EQ(one.overall, other.overall);
  EXPECT_EQ(one.unknown, other.unknown);
  EXPECT_EQ(one.island_count, other.island_count);
  EXPECT_EQ(one.island_of_link, other.island_of_link);
  EXPECT_TRUE(one.time_to_contact == other.time_to_contact ||
              (std::isnan(one.time_to_contact) && std::isnan(other.time_to_contact)))
      << one.time_to_contact << " and " << other.time_to_contact;
  ASSERT_EQ(one.changes.size(), other.changes.size());
  for (std::size_t i = 0; i < one.changes.size(); ++i) {
    EXPECT_EQ(one.changes[i].link_pair, other.changes[i].link_pair);
    EXPECT_EQ(one.changes[i].after, other.changes[i].after);
  }
  EXPECT_EQ(distanceAt(sparse, one.closest_of_all, kInfinity),
            distanceAt(complete, other.closest_of_all, kInfinity));
  for (std::size_t i = 0; i < one.closest.size(); ++i) {
    const double farthest = activationDistanceOf(sparse.setup.limits);
    EXPECT_EQ(distanceAt(sparse, one.closest[i], farthest),
              distanceAt(complete, other.closest[i], farthest));
  }
  EXPECT_EQ(sparse.buffers.memory.speed.scale, complete.buffers.memory.speed.scale);
  EXPECT_EQ(sparse.buffers.robots.scales, complete.buffers.robots.scales);
  EXPECT_EQ(sparse.buffers.distances.passed.size(), complete.buffers.distances.passed.size());
  EXPECT_EQ(sparse.buffers.counters.unknown_pairs, complete.buffers.counters.unknown_pairs);
  EXPECT_EQ(sparse.buffers.counters.unknown_links, complete.buffers.counters.unknown_links);
}

std::size_t movedBodies(const CycleBuffers& buffers) {
  std::size_t count = 0;
  forIndices(buffers.body_poses.moved.bodies, [&](std::size_t) { ++count; });
  return count;
}

TEST(RestingObjectsLaws, aCycleTellsWhatACycleTellsThatLooksAtEverything) {
  std::size_t rested = 0;
  std::size_t listed = 0;
  for (unsigned seed = 1; seed <= test::caseCount(10U); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    CycleSetup robots = test::randomSetup(kLinks, seed);
    robots.is_continuous = seed % 5 < 3;
    const bool is_slow = seed % 2 == 0;
    const bool seem_to_rest = seed % 4 == 0;
    // 0.2 m is more than any other distance that matters.
    robots.limits.report_distance = seem_to_rest ? 0.2 : seed % 3 == 0 ? 0.0 : 0.05;
    Random random(seed);
    const World world = crowdedWorld(350, random);
    CycleSetup setup =
        addWorld(robots, world, prepareObjects(world, RefineGeometry::mesh, {}), "map");
    if (seed % 3 == 1) {
      applyRulesText({"rules", "- {a: 'object_1*', b: 'object_2*', check: true}"},
                     IdleRule::is_error, setup);
    }
    ASSERT_FALSE(setup.carried.empty());
    Monitor sparse(setup, false, seem_to_rest);
    Monitor without_trees(setup, false, seem_to_rest, BroadPhaseKind::brute_force);
    Monitor complete(setup, true, seem_to_rest);
    Motion motion(setup.model, seed, is_slow);
    for (int cycle = 0; cycle < kCycles && !HasFailure(); ++cycle) {
      SCOPED_TRACE(testing::Message() << "cycle " << cycle);
      const LinkPoses& poses = motion.next();
      sparse.cycle(poses);
      without_trees.cycle(poses);
      complete.cycle(poses);
      expectSame(sparse, complete);
      expectSame(without_trees, complete);
      listed += sparse.buffers.memory.distance_cache.is_listed ? 1 : 0;
      rested += movedBodies(sparse.buffers) < setup.bodies.size() ? 1 : 0;
      if (random() % 30 == 0) {
        forgetPoses(sparse.buffers);
        forgetPoses(without_trees.buffers);
        forgetPoses(complete.buffers);
      }
    }
  }
  EXPECT_GT(rested, test::caseCount(std::size_t{20}))
      << "objects must rest in some cycles, or nothing is tested";
  EXPECT_GT(listed, test::caseCount(std::size_t{20})) << "the same of lists";
}

}  // namespace
}  // namespace collision_monitor::resting_objects_laws
