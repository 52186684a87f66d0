// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "pipeline/answers/carry_over.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/run_cycle.h"
#include "pipeline/look_ahead/find_motions.h"
#include "pipeline/world/add_world.h"
#include "support/random_poses.h"
#include "support/robots/hand_made_setup.h"
#include "support/robots/world_objects.h"

namespace collision_monitor::world_laws {
namespace {

using test::Random;

constexpr std::size_t kLinks = 8;
constexpr double kReach = 0.5;

/// A set-up, and what a watch keeps beside it.
struct Watched {
  explicit Watched(CycleSetup made)
      : setup(std::move(made)),
        buffers(makeBuffers(setup, BroadPhaseKind::automatic)),
        poses(test::knownPoses(setup)),
        tracker(makeVelocityTracker(setup.model)) {}

  /// Takes the poses of the robots' links; objects follow what carries them.
  void read(const LinkPoses& robots) {
    poses.stamp_ns = robots.stamp_ns;
    std::fill(poses.robot_stamp_ns.begin(), poses.robot_stamp_ns.end(), robots.stamp_ns);
    for (std::size_t i = 0; i < poses.status.size(); ++i) {
      const auto& joint = setup.model.links[i].parent_joint;
      if (i < kLinks) {
        poses.world_from_link[i] = robots.world_from_link[i];
        poses.status[i] = robots.status[i];
      } else if (joint) {
        const std::size_t parent = index(setup.model.joint(*joint).parent);
        poses.world_from_link[i] =
            poses.world_from_link[parent] * setup.model.joint(*joint).parent_from_joint;
        poses.status[i] = poses.status[parent];
      }
    }
    trackVelocities(setup.model, {}, tracker, poses);
    applyJointVelocities(setup.model, {}, poses);
  }

  void prepare(const LinkPoses& robots) {
    read(robots);
    learnPairs(setup, poses, buffers);
    keepPoses(poses, buffers.body_poses, buffers.memory.last);
  }

  void takeOver(const Watched& former) {
    const CarryPlan plan = planCarryOver(former.setup, setup);
    carryMotion(plan, setup, {former.poses, former.buffers.memory.last, former.tracker}, poses,
                buffers.memory, tracker);
    carryOver(plan, former.buffers.memory, buffers.memory);
  }

  void cycle(const LinkPoses& robots) {
    read(robots);
    runCycle(setup, poses, buffers);
  }

  CycleSetup setup;
  CycleBuffers buffers;
  LinkPoses poses;
  VelocityTracker tracker;
};

KnownPlaces places() {
  KnownPlaces places;
  for (std::size_t i = 0; i < kLinks; ++i) {
    places.links.push_back("link_" + std::to_string(i));
  }
  places.link_frames = places.links;
  places.world_frame = "map";
  return places;
}

ObjectGeometry randomGeometry(Random& random) {
  const double size = 0.02 + 0.01 * static_cast<double>(random() % 8);
  switch (random() % 5) {
    case 0:
      return Sphere{size};
    case 1:
      return Cylinder{2.0 * size, size};
    case 2:
      return Cone{size, size};
    case 3:
      return Plane{test::randomPoint(random, 1.0), -0.4};
    default:
      return Box{{size, 2.0 * size, 3.0 * size}};
  }
}

WorldObject randomObject(const std::string& name, Random& random) {
  WorldObject object =
      test::objectOf(name, randomGeometry(random), test::randomPose(random, kReach));
  if (random() % 3 == 0) {
    object = test::attached(object, "link_" + std::to_string(random() % kLinks));
    object.frame_from_object = test::randomPose(random, 0.1);
  }
  return object;
}

/// Adds, moves, removes, attaches and detaches some objects.
World changed(const World& world, Random& random) {
  std::vector<WorldObject> objects;
  for (const auto& [name, object] : world.objects) {
    const std::uint64_t fate = random() % 4;
    if (fate > 0) {
      objects.push_back(fate == 1 ? randomObject(name, random) : *object);
    }
  }
  for (std::uint64_t i = 0; i < 1 + random() % 3; ++i) {
    const std::string name = "object_" + std::to_string(random() % 1000000);
    if (world.objects.count(name) == 0) {
      objects.push_back(randomObject(name, random));
    }
  }
  return test::worldOf(objects, places());
}

CycleSetup robotsWithoutHysteresis(unsigned seed) {
  CycleSetup robots = test::randomSetup(kLinks, seed);
  robots.limits.hysteresis = 0.0;
  robots.limits.time_hysteresis = 0.0;
  robots.limits.warning_time = 0.0;
  robots.is_continuous = true;
  robots.refine.budget = 100'000'000;
  return robots;
}

CycleSetup withWorld(const CycleSetup& robots, const World& world) {
  return addWorld(robots, world, prepareObjects(world, RefineGeometry::mesh, {}), "map");
}

/// 10 ms later, up to 2 cm away.
void moveOn(Random& random, LinkPoses& poses) {
  poses.stamp_ns += 10'000'000;
  for (std::size_t link = 0; link < kLinks; ++link) {
    poses.world_from_link[link].translation += test::randomPoint(random, 0.02);
  }
}

void expectAlike(const Watched& after, const Watched& fresh) {
  ASSERT_EQ(after.setup.checked.size(), fresh.setup.checked.size());
  const PairEvents& events = after.buffers.events;
  for (std::size_t i = 0; i < events.verdicts.size(); ++i) {
    if (events.passed[i] != kNone) {
      continue;  // a monitor that has just started knows no way
    }
    EXPECT_EQ(events.verdicts[i], fresh.buffers.events.verdicts[i]);
    const std::uint32_t closest = events.closest[i];
    const std::uint32_t of_fresh = fresh.buffers.events.closest[i];
    if (events.verdicts[i] != Verdict::clear && closest != kNone && of_fresh != kNone) {
      const PairDistance& one = after.buffers.distances.pairs[closest];
      const PairDistance& other = fresh.buffers.distances.pairs[of_fresh];
      EXPECT_EQ(one.quality, other.quality);
      EXPECT_NEAR(one.measured.distance, other.measured.distance, 1e-6);
    }
  }
}

TEST(WorldLaws, theFirstCycleAfterAChange_equalsThatOfAMonitorStartedWithTheWorld) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const CycleSetup robots = robotsWithoutHysteresis(seed);
    LinkPoses poses = test::randomLinkPoses(robots, kReach, seed);
    poses.stamp_ns = 1'000'000'000;
    World world;
    auto watched = std::make_unique<Watched>(withWorld(robots, world));
    for (int change = 0; change < 10; ++change) {
      world = changed(world, random);
      auto next = std::make_unique<Watched>(withWorld(robots, world));
      next->prepare(poses);
      for (int i = 0; i < 3; ++i) {  // while the change is prepared
        moveOn(random, poses);
        watched->cycle(poses);
      }
      next->takeOver(*watched);
      watched = std::move(next);
      moveOn(random, poses);
      watched->cycle(poses);
      Watched fresh(withWorld(robots, world));
      fresh.prepare(poses);
      fresh.cycle(poses);
      expectAlike(*watched, fresh);
    }
  }
}

TEST(WorldLaws, equalWorlds_giveEqualSetUpsHoweverTheyCame) {
  Random random(7);
  const CycleSetup robots = robotsWithoutHysteresis(7);
  World world;
  for (int change = 0; change < 20; ++change) {
    world = changed(world, random);
  }
  std::vector<WorldObject> objects;
  for (const auto& [name, object] : world.objects) {
    objects.insert(objects.begin(), *object);
  }
  const CycleSetup one = withWorld(robots, world);
  const CycleSetup other = withWorld(robots, test::worldOf(objects, places()));
  ASSERT_EQ(one.table.size(), other.table.size());
  for (std::size_t i = 0; i < one.table.size(); ++i) {
    EXPECT_EQ(one.table.pairs()[i].a, other.table.pairs()[i].a);
    EXPECT_EQ(one.table.pairs()[i].b, other.table.pairs()[i].b);
  }
}

/// A ball that passes through a thin plate of the world in one step.
struct Crossing {
  CycleSetup robots;
  LinkPoses before;
  LinkPoses after;
};

Crossing crossing() {
  std::vector<test::ShapeOnLink> shapes;
  for (std::size_t i = 0; i < kLinks; ++i) {
    shapes.push_back({i, Sphere{0.02}});
  }
  Crossing scene{test::handMadeSetup(shapes), {}, {}};
  scene.robots.is_continuous = true;
  scene.before = test::knownPoses(scene.robots);
  for (std::size_t i = 0; i < kLinks; ++i) {
    scene.before.world_from_link[i] = test::at(0, 10.0 * static_cast<double>(i), 0.5);
  }
  scene.before.stamp_ns = 1'000'000'000;
  scene.after = scene.before;
  scene.after.stamp_ns += 10'000'000;
  scene.after.world_from_link[0] = test::at(0, 0, -0.5);
  return scene;
}

TEST(WorldLaws, aContactOnTheWay_isFoundAcrossAChange) {
  const Crossing scene = crossing();
  const WorldObject plate = test::objectOf("plate", Box{{1, 1, 0.001}});
  Watched former(withWorld(scene.robots, test::worldOf({plate}, places())));
  former.cycle(scene.before);
  Watched next(withWorld(
      scene.robots,
      test::worldOf({plate, test::objectOf("other", Sphere{0.1}, test::at(5, 5, 5))}, places())));
  next.prepare(scene.before);
  next.takeOver(former);
  next.cycle(scene.after);
  EXPECT_EQ(next.buffers.distances.passed.size(), 1U);
}

TEST(WorldLaws, anObjectMovedByTheUser_isNoContactOnTheWay) {
  const Crossing scene = crossing();
  const Box plate{{1, 1, 0.001}};
  Watched former(
      withWorld(scene.robots, test::worldOf({test::objectOf("plate", plate)}, places())));
  former.cycle(scene.before);
  Watched next(withWorld(
      scene.robots, test::worldOf({test::objectOf("plate", plate, test::at(0, 0, 1))}, places())));
  next.prepare(scene.before);
  next.takeOver(former);
  LinkPoses later = scene.before;
  later.stamp_ns += 10'000'000;
  next.cycle(later);
  EXPECT_TRUE(next.buffers.distances.passed.empty());
  EXPECT_EQ(next.buffers.events.overall, Verdict::clear);
}

TEST(WorldLaws, attachingAndDetaching_changesNoOtherVerdict) {
  const Crossing scene = crossing();
  const WorldObject part = test::objectOf("part", Box{{0.01, 0.01, 0.01}}, test::at(0, 0, 0.55));
  const WorldObject held = test::attached(
      test::objectOf("part", Box{{0.01, 0.01, 0.01}}, test::at(0, 0, 0.05)), "link_0");
  auto watched =
      std::make_unique<Watched>(withWorld(scene.robots, test::worldOf({part}, places())));
  LinkPoses poses = scene.before;
  for (int i = 0; i < 100; ++i) {
    const World world = test::worldOf({i % 2 == 0 ? held : part}, places());
    auto next = std::make_unique<Watched>(withWorld(scene.robots, world));
    next->prepare(poses);
    next->takeOver(*watched);
    watched = std::move(next);
    poses.stamp_ns += 10'000'000;
    watched->cycle(poses);
    EXPECT_EQ(watched->buffers.events.overall, i % 2 == 0 ? Verdict::clear : Verdict::warning);
    EXPECT_TRUE(watched->buffers.distances.passed.empty());
  }
}

}  // namespace
}  // namespace collision_monitor::world_laws
