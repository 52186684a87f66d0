// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "property/pipeline/watched_world.h"

/// What happens on the way from one set-up to the next.
namespace collision_monitor::world_laws {
namespace {

/// A ball that passes through a thin plate of the world in one step.
struct Crossing {
  CycleSetup robots;
  LinkPoses before;
  LinkPoses after;
};

Crossing crossing(const Shape& first = Sphere{0.02}) {
  std::vector<test::ShapeOnLink> shapes{{0, first}};
  for (std::size_t i = 1; i < kLinks; ++i) {
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

/// Many small objects far away, so that a cycle neither judges all pairs nor places all objects,
/// and some more.
World farObjectsAnd(const std::vector<WorldObject>& more) {
  std::vector<WorldObject> objects = more;
  for (int i = 0; i < 70; ++i) {
    objects.push_back(
        test::objectOf("far_" + std::to_string(i), Sphere{0.1}, test::at(50.0 + i, 50, 50)));
  }
  return test::worldOf(objects, places());
}

TEST(WorldChangeLaws, aContactOnTheWay_isFoundAcrossAChange) {
  const Crossing scene = crossing();
  const WorldObject plate = test::objectOf("plate", Box{{1, 1, 0.001}});
  Watched former(withWorld(scene.robots, test::worldOf({plate}, places())));
  former.cycle(scene.before);
  Watched next(withWorld(
      scene.robots,
      test::worldOf({plate, test::objectOf("other", Sphere{0.1}, test::at(5, 5, 5))}, places())));
  next.prepare(scene.before, former);
  next.takeOver(former);
  next.cycle(scene.after);
  EXPECT_EQ(next.buffers.distances.passed.size(), 1U);
}

TEST(WorldChangeLaws, aContactOnTheWayWithAnObjectThatRests_isFoundAcrossAChange) {
  const Crossing scene = crossing();
  const World world = farObjectsAnd({test::objectOf("plate", Box{{1, 1, 0.001}})});
  Watched former(withWorld(scene.robots, world));
  LinkPoses before = scene.before;
  for (int i = 0; i < 3; ++i) {
    before.stamp_ns += 1'000'000;
    former.cycle(before);
  }
  Watched next(withWorld(scene.robots, world));
  next.prepare(before, former);
  next.takeOver(former);
  next.cycle(scene.after);
  EXPECT_LT(next.buffers.body_poses.moved.links.back().last, next.setup.model.links.size());
  EXPECT_EQ(next.buffers.distances.passed.size(), 1U);
}

TEST(WorldChangeLaws, aContactThatBeginsWhileAChangeIsPreparedAndEndsAfterIt_isTakenBack) {
  Crossing scene = crossing();
  scene.robots.is_continuous = false;
  scene.robots.ahead.horizon = 0.0;  // or the fast ball would be measured wherever it is
  scene.robots.limits.warning_time = 0.0;
  const WorldObject ball = test::objectOf("ball", Sphere{0.1}, test::at(0, 0, -0.5));
  const WorldObject closest = test::objectOf("closest", Sphere{0.1}, test::at(0, 10, 0.9));
  Watched former(withWorld(scene.robots, farObjectsAnd({ball, closest})));
  former.cycle(scene.before);
  const WorldObject other = test::objectOf("other", Sphere{0.1}, test::at(5, 5, 5));
  Watched next(withWorld(scene.robots, farObjectsAnd({ball, closest, other})));
  next.prepare(scene.before, former);
  former.cycle(scene.after);
  ASSERT_EQ(former.buffers.events.changes.size(), 1U);
  ASSERT_FALSE(former.buffers.memory.judges_all);
  next.takeOver(former);
  ASSERT_FALSE(next.buffers.memory.judges_all);
  LinkPoses apart = scene.before;
  apart.stamp_ns = scene.after.stamp_ns + 10'000'000;
  next.cycle(apart);
  const std::vector<VerdictChange>& changes = next.buffers.events.changes;
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_EQ(changes[0].before, Verdict::contact);
  EXPECT_EQ(changes[0].after, Verdict::clear);
}

TEST(WorldChangeLaws, anObjectMovedByTheUser_isNoContactOnTheWay) {
  const Crossing scene = crossing();
  const Box plate{{1, 1, 0.001}};
  Watched former(
      withWorld(scene.robots, test::worldOf({test::objectOf("plate", plate)}, places())));
  former.cycle(scene.before);
  Watched next(withWorld(
      scene.robots, test::worldOf({test::objectOf("plate", plate, test::at(0, 0, 1))}, places())));
  next.prepare(scene.before, former);
  next.takeOver(former);
  LinkPoses later = scene.before;
  later.stamp_ns += 10'000'000;
  next.cycle(later);
  EXPECT_TRUE(next.buffers.distances.passed.empty());
  EXPECT_EQ(next.buffers.events.overall, Verdict::clear);
}

TEST(WorldChangeLaws, aTurnWhileAChangeIsPrepared_isNotForgotten) {
  Crossing scene = crossing(Box{{0.01, 0.01, 1}});
  scene.robots.is_continuous = false;
  scene.robots.ahead.horizon = 0.0;
  scene.robots.limits.warning_time = 0.0;
  const auto leaningTo = [](double x) {
    return Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), Eigen::Vector3d(x, 0, 1))
        .toRotationMatrix();
  };
  scene.before.world_from_link[0].rotation = leaningTo(1.0);
  scene.before.world_from_link[1] = test::at(-0.5, 0, 1);
  scene.before.world_from_link[2] = test::at(0, 30, 0.65);  // near link 3: the closest pair
  LinkPoses turned = scene.before;
  turned.world_from_link[0].rotation = leaningTo(-1.0);
  for (const LinkStatus meanwhile : {LinkStatus::known, LinkStatus::stale}) {
    Watched former(withWorld(scene.robots, farObjectsAnd({})));
    former.cycle(turned);
    Watched next(withWorld(scene.robots, farObjectsAnd({})));
    next.prepare(scene.before, former);
    LinkPoses second = meanwhile == LinkStatus::known ? scene.before : turned;
    second.status[0] = meanwhile;
    next.prepare(second, former);
    next.takeOver(former);
    turned.stamp_ns += 10'000'000;
    next.cycle(turned);
    EXPECT_EQ(next.buffers.events.overall, Verdict::contact);
  }
}

TEST(WorldChangeLaws, attachingAndDetaching_changesNoOtherVerdict) {
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
    next->prepare(poses, *watched);
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
