// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "collision_monitor/model/kinematics.h"
#include "pipeline/cycle/run_cycle.h"
#include "pipeline/states/check_states.h"
#include "pipeline/world/add_world.h"
#include "support/fixed_seed.h"
#include "support/query_meshes.h"
#include "support/robots/geometry_setup.h"
#include "support/robots/hand_made_setup.h"
#include "support/robots/random_model.h"
#include "support/robots/world_objects.h"
#include "support/sample_meshes.h"

// States of robots of meshes beside objects, held to cycles without a budget.
namespace collision_monitor::test::states_beside_objects {
namespace {

constexpr std::size_t kLinks = 4;
constexpr std::size_t kStates = 40;

/// Four links of one geometry each.
CycleSetup fittedLinks() {
  SetupOptions options;
  options.limits.warning_distance = 0.03;
  CycleSetup links = geometrySetup(
      {scaled(angleMesh(), 0.5), bumpyMesh(0.08, 8), Capsule{0.08, 0.03}, Cylinder{0.05, 0.1}},
      options);
  links.is_continuous = false;
  return links;
}

/// A random tree of these links.
CycleSetup anyRobot(CycleSetup robot, Random& random) {
  do {
    robot.model = randomModel(kLinks, random);
  } while (robot.model.variable_count == 0);
  for (Joint& joint : robot.model.joints) {
    joint.parent_from_joint.translation *= 0.25;
  }
  for (std::size_t i = 0; i < kLinks; ++i) {
    Link& link = robot.model.links[i];
    link.name = link.frame = "link_" + std::to_string(i);
    link.has_given_shapes = true;
  }
  return robot;
}

/// Long and flat ones among them, whose balls reach far beyond them.
World anyWorld(const CycleSetup& robot, Random& random) {
  const std::vector<ObjectGeometry> geometries{
      Box{{0.6, 0.5, 0.01}},
      Box{{0.02, 0.02, 0.8}},
      Cylinder{0.5, 0.02},
      Capsule{0.4, 0.02},
      Sphere{0.05},
      std::make_shared<const TriangleMesh>(scaled(angleMesh(), 3.0)),
      Plane{randomPoint(random, 1.0), -0.4}};
  std::vector<WorldObject> objects;
  for (std::size_t i = 0; i < geometries.size(); ++i) {
    objects.push_back(
        objectOf("object_" + std::to_string(i), geometries[i], randomPose(random, 0.6)));
    objects.back().padding = i % 3 == 0 ? 0.01 : 0.0;
  }
  return worldOf(objects, placesOf(robot.model, "map"));
}

struct Counts {
  std::size_t contact{0};
  std::size_t warning{0};
  std::size_t clear{0};
};

void compareWithCycles(const CycleSetup& setup, const JointPositions& positions, Counts& counts) {
  const std::vector<Pose> roots(setup.model.robots.size());
  StatesWork work = makeStatesWork(setup, standingAt(setup.model, roots));
  std::vector<StateCheck> contact;
  std::vector<StateCheck> nearest;
  checkStatesExactly(setup, positions, StateQuestion::contact, work, contact);
  checkStatesExactly(setup, positions, StateQuestion::nearest, work, nearest);
  CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::brute_force);
  buffers.refine.limits.budget = std::numeric_limits<std::uint32_t>::max();
  const auto variables = static_cast<std::ptrdiff_t>(setup.model.variable_count);
  for (std::size_t i = 0; i < kStates; ++i) {
    SCOPED_TRACE(testing::Message() << "state " << i);
    const auto first = positions.begin() + static_cast<std::ptrdiff_t>(i) * variables;
    LinkPoses poses = knownPoses(setup);
    placeLinks(setup.model, JointPositions(first, first + variables), roots, poses.world_from_link);
    resetMemory(buffers);
    runCycle(setup, poses, buffers);
    const Verdict verdict = buffers.events.overall;
    ASSERT_EQ(nearest[i].verdict, verdict);
    ASSERT_EQ(contact[i].verdict == Verdict::contact, verdict == Verdict::contact);
    ++(verdict == Verdict::contact   ? counts.contact
       : verdict == Verdict::warning ? counts.warning
                                     : counts.clear);
  }
}

TEST(StatesBesideObjectsLaws, verdictsAreThoseOfCyclesWithoutABudget) {
  Random random(kSeed);
  Counts counts;
  const CycleSetup links = fittedLinks();
  for (int round = 0; round < 40; ++round) {
    SCOPED_TRACE(testing::Message() << "round " << round);
    const CycleSetup robot = anyRobot(links, random);
    World world = anyWorld(robot, random);
    // Of many objects some is always near.
    for (int i = 0; i < 6; ++i) {
      if (random() % 2 == 0) {
        world.objects.erase("object_" + std::to_string(i));
      }
    }
    const CycleSetup setup =
        addWorld(robot, world, prepareObjects(world, RefineGeometry::mesh, {}), "map");
    JointPositions positions;
    for (std::size_t i = 0; i < kStates * setup.model.variable_count; ++i) {
      positions.push_back(uniform(random, -1.5, 1.5));
    }
    compareWithCycles(setup, positions, counts);
  }
  EXPECT_GT(counts.contact, 100U);
  EXPECT_GT(counts.warning, 20U);
  EXPECT_GT(counts.clear, 100U);
}

}  // namespace
}  // namespace collision_monitor::test::states_beside_objects
