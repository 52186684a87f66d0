// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause

// Beside many objects, the list of near pairs was made with boxes seen from a moving base, and
// ended by motions seen from the world. Two links that rode along and then turned at each other, no
// faster than before, were not in the list: their time to contact came late.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <vector>

#include "model/object_links.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/run_cycle.h"
#include "pipeline/objects/carry_objects.h"
#include "pipeline/world/add_world.h"
#include "support/robots/hand_made_setup.h"
#include "support/robots/world_objects.h"

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

constexpr double kSpeed = 0.5;  // [m/s]

/// A base, two links 0.12 m apart, and one that is always nearer to the base; boxes far away.
CycleSetup baseAndBoxes() {
  CycleSetup robots =
      handMadeSetup({{0, Sphere{0.1}}, {1, Sphere{0.1}}, {2, Sphere{0.1}}, {3, Sphere{0.1}}});
  robots.ahead.horizon = 0.5;
  robots.is_continuous = false;
  robots.limits.report_distance = 0.05;
  std::vector<WorldObject> boxes;
  for (int i = 0; i < 100; ++i) {
    boxes.push_back(
        objectOf("box " + std::to_string(i), Box{{0.02, 0.02, 0.02}}, at(20.0 + 0.1 * i, 0, 0)));
    boxes.back().frame = "map";
  }
  KnownPlaces places;
  places.links = places.link_frames = {"link_0", "link_1", "link_2", "link_3"};
  places.world_frame = "map";
  const World world = worldOf(boxes, places);
  return addWorld(robots, world, prepareObjects(world, RefineGeometry::mesh, {}), "map");
}

TEST(LinksOnAMovingBase, turnAtEachOther_toldAtOnceBesideManyObjects) {
  const CycleSetup setup = baseAndBoxes();
  ASSERT_FALSE(setup.carried.empty());
  const std::vector<ObjectRun> objects = objectRuns(setup.model);
  CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::automatic);
  std::array<Vector3d, 4> at = {Vector3d(0, 0, 0), Vector3d(-0.16, 1, 0), Vector3d(0.16, 1, 0),
                                Vector3d(0, 0, 0.24)};
  std::array<Vector3d, 4> velocities;
  velocities.fill(Vector3d(0, kSpeed, 0));
  LinkPoses poses = knownPoses(setup);
  std::fill(poses.velocities.known.begin(), poses.velocities.known.end(), 1);
  for (int cycle = 0; cycle <= 20; ++cycle) {
    if (cycle == 20) {
      ASSERT_TRUE(buffers.memory.distance_cache.is_listed);
      EXPECT_EQ(buffers.events.time_to_contact, std::numeric_limits<double>::infinity());
      velocities[1] = Vector3d(kSpeed, 0, 0);
      velocities[2] = Vector3d(-kSpeed, 0, 0);
    }
    poses.stamp_ns += 1'000'000;
    for (std::size_t i = 0; i < at.size(); ++i) {
      poses.world_from_link[i].translation = at[i];
      poses.velocities.of_link[i].linear = velocities[i];
      at[i] += 0.001 * velocities[i];
    }
    carryPoses(setup.model, objects, poses);
    carryVelocities(objects, poses);
    runCycle(setup, poses, buffers);
  }
  EXPECT_NEAR(buffers.events.time_to_contact, 0.12, 1e-3);
}

}  // namespace
}  // namespace collision_monitor::test
