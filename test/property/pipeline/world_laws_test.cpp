// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "property/pipeline/watched_world.h"
#include "support/random_poses.h"
#include "support/robots/geometry_setup.h"

namespace collision_monitor::world_laws {
namespace {

using test::Random;

constexpr double kReach = 0.5;

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

CycleSetup withoutHysteresis(CycleSetup robots) {
  robots.limits.hysteresis = 0.0;
  robots.limits.time_hysteresis = 0.0;
  robots.limits.warning_time = 0.0;
  robots.is_continuous = true;
  robots.refine.budget = 100'000'000;
  return robots;
}

CycleSetup robotsWithoutHysteresis(unsigned seed) {
  return withoutHysteresis(test::randomSetup(kLinks, seed));
}

/// 10 ms later, up to 2 cm away. Links may fall silent, and come back.
void moveOn(Random& random, LinkPoses& poses) {
  poses.stamp_ns += 10'000'000;
  for (std::size_t link = 0; link < kLinks; ++link) {
    poses.world_from_link[link].translation += test::randomPoint(random, 0.02);
    const bool changes = random() % 20 == 0;
    const bool is_silent = (poses.status[link] != LinkStatus::known) != changes;
    poses.status[link] = is_silent ? LinkStatus::missing : LinkStatus::known;
  }
}

/// A world so large that a cycle does not judge all of its pairs.
World manyObjects(Random& random) {
  World world;
  while (world.objects.size() < 12) {
    world = changed(world, random);
  }
  return world;
}

void expectAlike(const Watched& after, const Watched& fresh) {
  ASSERT_EQ(after.setup.checked.size(), fresh.setup.checked.size());
  const PairEvents& events = after.buffers.events;
  EXPECT_EQ(events.unknown, fresh.buffers.events.unknown);
  if (after.buffers.distances.passed.empty()) {
    EXPECT_EQ(events.overall, fresh.buffers.events.overall);
  }
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
      if (one.quality != Quality::estimate) {  // depths are followed from cycle to cycle
        EXPECT_NEAR(one.measured.distance, other.measured.distance, 1e-6);
      }
    }
  }
}

/// Robots of these links, whose objects change while they move.
void expectChangesAlike(const CycleSetup& robots, unsigned seed) {
  Random random(seed);
  LinkPoses poses = test::randomLinkPoses(robots, kReach, seed);
  poses.stamp_ns = 1'000'000'000;
  World world = manyObjects(random);
  auto watched = std::make_unique<Watched>(withWorld(robots, world));
  for (int change = 0; change < 10; ++change) {
    world = changed(world, random);
    auto next = std::make_unique<Watched>(withWorld(robots, world));
    for (int times = 0; times < 2; ++times) {
      next->prepare(poses, *watched);
      for (int i = 0; i < 3; ++i) {  // meanwhile
        moveOn(random, poses);
        watched->cycle(poses);
      }
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

TEST(WorldLaws, theFirstCycleAfterAChange_equalsThatOfAMonitorStartedWithTheWorld) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    expectChangesAlike(robotsWithoutHysteresis(seed), seed);
  }
}

TEST(WorldLaws, theFirstCycleAfterAChange_withMeshes_equalsThatOfAMonitorStartedWithTheWorld) {
  SetupOptions options;
  options.default_limits.max_shapes = 1;
  std::vector<Geometry> geometries(5, test::angleMesh());
  geometries.resize(kLinks, Cylinder{0.1, 0.05});
  const CycleSetup robots = withoutHysteresis(test::geometrySetup(geometries, options));
  for (unsigned seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    expectChangesAlike(robots, seed);
  }
}

/// So many objects at rest in the world that cycles leave them out.
World crowd(Random& random) {
  std::vector<WorldObject> objects;
  for (int i = 0; i < 80; ++i) {
    objects.push_back(test::objectOf("box_" + std::to_string(i), Box{{0.02, 0.03, 0.04}},
                                     test::randomPose(random, 2.0 * kReach)));
  }
  return test::worldOf(objects, places());
}

TEST(WorldLaws, objectsThatStand_areLeftOutFromTheFirstCycleOnAndNothingDiffers) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const CycleSetup robots = robotsWithoutHysteresis(seed);
    LinkPoses poses = test::randomLinkPoses(robots, kReach, seed);
    poses.stamp_ns = 1'000'000'000;
    Watched former(withWorld(robots, World()));
    for (int i = 0; i < 3; ++i) {
      moveOn(random, poses);
      former.cycle(poses);
    }
    const World world = crowd(random);
    Watched next(withWorld(robots, world));
    next.prepare(poses, former);
    next.takeOver(former);
    Watched fresh(withWorld(robots, world));
    fresh.prepare(poses);
    for (int i = 0; i < 5; ++i) {
      moveOn(random, poses);
      next.cycle(poses);
      fresh.cycle(poses);
      ASSERT_EQ(next.setup.carried.size(), 1U);
      const std::vector<IndexRange>& moved = next.buffers.body_poses.moved.links;
      EXPECT_EQ(moved.back().last, next.setup.carried[0].first_link);
      expectAlike(next, fresh);
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

}  // namespace
}  // namespace collision_monitor::world_laws
