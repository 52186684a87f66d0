// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause

// Pairs of two objects, which rules ask for.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "collision_monitor/model/problems.h"
#include "model/object_links.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/run_cycle.h"
#include "pipeline/objects/carry_objects.h"
#include "pipeline/setup/setup_parts.h"
#include "pipeline/world/add_world.h"
#include "support/robots/hand_made_setup.h"
#include "support/robots/world_objects.h"

namespace collision_monitor::test {
namespace {

WorldObject boxOn(const std::string& frame, const std::string& name, double x) {
  WorldObject object = objectOf(name, Box{{0.1, 0.1, 0.1}}, at(x, 0.0, 0.0));
  object.frame = frame;
  object.group = "boxes";
  return object;
}

/// A ball far away; a table and a shelf in the world, and a box on a cart.
CycleSetup cartSetup(const std::string& rules, IdleRule idle = IdleRule::is_error) {
  const CycleSetup robots = handMadeSetup({{0, Sphere{0.1}}});
  KnownPlaces places;
  places.links = places.link_frames = {"link_0"};
  places.world_frame = "map";
  places.has_frame = [](const std::string& frame) { return frame == "cart"; };
  const World world = worldOf(
      {boxOn("map", "table", 5.0), boxOn("map", "shelf", 7.0), boxOn("cart", "box", 0.0)}, places);
  CycleSetup setup =
      addWorld(robots, world, prepareObjects(world, RefineGeometry::mesh, {}), "map");
  applyRulesText({"rules", rules}, idle, setup);
  return setup;
}

std::size_t checkedPairs(const CycleSetup& setup) { return setup.checked.size(); }

TEST(AskedPairs, withoutARule_noPairOfTwoObjects) { EXPECT_EQ(checkedPairs(cartSetup("")), 3U); }

TEST(AskedPairs, ofARuleWithObjectsAlone_areChecked) {
  EXPECT_EQ(checkedPairs(cartSetup("- {a: box, b: table, check: true}")), 4U);
  EXPECT_EQ(checkedPairs(cartSetup("- {a: box, b: [table, shelf], check: true}")), 5U);
  EXPECT_EQ(checkedPairs(cartSetup("- {a: {group: boxes}, b: {group: boxes}, check: true}")), 5U);
}

TEST(AskedPairs, ofARuleThatAlsoSelectsLinks_areNotMeant) {
  EXPECT_EQ(checkedPairs(cartSetup("- {a: '*', b: '*', check: true}")), 3U);
  EXPECT_EQ(checkedPairs(cartSetup("- {a: '*', b: box, warning_distance: 0.1}")), 3U);
}

TEST(AskedPairs, lastRuleDecides) {
  EXPECT_EQ(checkedPairs(cartSetup("- {a: box, b: [table, shelf], check: true}\n"
                                   "- {a: box, b: shelf, check: false}")),
            4U);
}

TEST(AskedPairs, ofObjectsThatMoveTogether_areRefused) {
  EXPECT_THROW(cartSetup("- {a: table, b: shelf, check: true}"), SetupError);
}

TEST(AskedPairs, otherRules_takeThemBack) {
  const CycleSetup setup = cartSetup("- {a: box, b: [table, shelf], check: true}");
  SetupReport report;
  const CycleSetup changed = withPairRules(setup, setup.limits, {}, report);
  EXPECT_EQ(checkedPairs(changed), 3U);
  EXPECT_EQ(changed.link_pairs.size(), 3U);
}

TEST(AskedPairs, cartThatReachesTheTable_isInContact) {
  const CycleSetup setup = cartSetup("- {a: box, b: table, check: true}");
  const std::vector<ObjectRun> objects = objectRuns(setup.model);
  CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::automatic);
  LinkPoses poses = knownPoses(setup);
  poses.world_from_link[0].translation.z() = 9.0;
  const auto cart = std::find_if(setup.model.links.begin(), setup.model.links.end(),
                                 [](const Link& link) { return link.name == "cart"; }) -
                    setup.model.links.begin();
  for (const double x : {1.0, 4.9}) {
    poses.stamp_ns += 10'000'000;
    poses.world_from_link[static_cast<std::size_t>(cart)].translation.x() = x;
    carryPoses(setup.model, objects, poses);
    runCycle(setup, poses, buffers);
    EXPECT_EQ(buffers.events.overall == Verdict::contact, x > 4.0);
  }
}

}  // namespace
}  // namespace collision_monitor::test
