// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/world/add_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "collision_monitor/model/kinematics.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/run_cycle.h"
#include "support/robots/robot_moves.h"
#include "support/robots/urdf_text.h"
#include "support/robots/world_objects.h"

namespace collision_monitor::test {
namespace {

const Box kBox{{0.1, 0.1, 0.1}};

std::string ball(double radius) { return "<sphere radius='" + std::to_string(radius) + "'/>"; }

/// base - (fixed) - flange - (slides along x) - arm - (fixed) - hand - (slides) - finger; balls of
/// 5 cm a meter apart, and the flange without geometry.
CycleSetup gripperSetup(SetupOptions options = SetupOptions()) {
  options.meshes.is_in_process = true;
  const std::string xml = robotXml(
      linkXml("base", ball(0.05)) + "<link name='flange'/>" + linkXml("arm", ball(0.05)) +
      linkXml("hand", ball(0.05)) + linkXml("finger", ball(0.05)) +
      jointXml("mount", "fixed", "base", "flange", "<origin xyz='1 0 0'/>") +
      jointXml("slide", "prismatic", "flange", "arm",
               "<axis xyz='1 0 0'/><limit lower='-9' upper='9' effort='1' velocity='1'/>") +
      jointXml("wrist", "fixed", "arm", "hand", "<origin xyz='1 0 0'/>") +
      jointXml("grip", "prismatic", "hand", "finger",
               "<origin xyz='1 0 0'/><axis xyz='0 1 0'/>"
               "<limit lower='-9' upper='9' effort='1' velocity='1'/>"));
  return buildSetup({describeText(xml)}, textLoader({}), options);
}

/// Elements are measured up to a meter apart.
CycleSetup farSeeingSetup() {
  SetupOptions options;
  options.limits.report_distance = 1.0;
  options.refine.limits.distance = 1.0;
  return gripperSetup(options);
}

CycleSetup withWorld(const CycleSetup& robots, const World& world) {
  return addWorld(robots, world, prepareObjects(world, RefineGeometry::mesh, {}), "map");
}

std::set<std::string> pairsOf(const CycleSetup& setup, const std::string& name) {
  std::set<std::string> others;
  for (const CheckedLinkPair& pair : setup.checked) {
    const std::string& a = setup.model.link(pair.a).name;
    const std::string& b = setup.model.link(pair.b).name;
    if (a == name || b == name) {
      others.insert(a == name ? b : a);
    }
  }
  return others;
}

using Names = std::set<std::string>;

TEST(AddWorld, objectsBecomeLinksBehindThoseOfTheRobots) {
  const CycleSetup robots = gripperSetup();
  const CycleSetup setup =
      withWorld(robots, worldOf({objectOf("table", kBox, at(0, 0, -1)), objectOf("crate", kBox)}));
  ASSERT_EQ(setup.model.links.size(), robots.model.links.size() + 3);
  EXPECT_EQ(setup.model.links[5].name, "map");
  EXPECT_FALSE(hasShapes(setup.model.links[5]));
  EXPECT_EQ(setup.model.links[6].name, "crate");
  EXPECT_EQ(setup.model.links[7].name, "table");
  const std::vector<Pose> poses = defaultPoses(setup.model);
  EXPECT_EQ(poses[7].translation.z(), -1.0);
  for (std::size_t i = 0; i < robots.bodies.size(); ++i) {
    EXPECT_EQ(setup.bodies[i].link, robots.bodies[i].link);
  }
}

TEST(AddWorld, withoutObjects_nothingChanges) {
  const CycleSetup robots = gripperSetup();
  const CycleSetup setup = withWorld(robots, World());
  EXPECT_EQ(setup.model.links.size(), robots.model.links.size());
  EXPECT_EQ(setup.table.size(), robots.table.size());
}

TEST(AddWorld, anObject_isCheckedAgainstAllLinksAndNoObject) {
  const CycleSetup setup =
      withWorld(gripperSetup(), worldOf({objectOf("table", kBox), objectOf("crate", kBox)}));
  EXPECT_EQ(pairsOf(setup, "table"), (Names{"base", "arm", "hand", "finger"}));
}

TEST(AddWorld, anObject_mayTouchItsTouchLinks) {
  WorldObject floor = objectOf("floor", Plane());
  floor.touch_links = {"base", "finger"};
  EXPECT_EQ(pairsOf(withWorld(gripperSetup(), worldOf({floor})), "floor"), (Names{"arm", "hand"}));
}

TEST(AddWorld, anObjectInALinksFrame_movesWithItAndIsCheckedAgainstIt) {
  WorldObject lamp = objectOf("lamp", kBox);
  lamp.frame = "flange";
  const CycleSetup setup = withWorld(gripperSetup(), worldOf({lamp}, [] {
                                       KnownPlaces places = armPlaces();
                                       places.link_frames.push_back("flange");
                                       return places;
                                     }()));
  EXPECT_EQ(pairsOf(setup, "lamp"), (Names{"base", "arm", "hand", "finger"}));
  EXPECT_EQ(defaultPoses(setup.model).back().translation.x(), 1.0);
}

TEST(AddWorld, anAttachedObject_mayTouchWhatMovesWithItAndItsTouchLinks) {
  const CycleSetup robots = gripperSetup();
  const World world =
      worldOf({attached(objectOf("part", kBox), "hand"), objectOf("table", kBox),
               attached(objectOf("sensor", kBox), "arm"), attached(objectOf("cap", kBox), "base")});
  EXPECT_EQ(pairsOf(withWorld(robots, world), "part"), (Names{"base", "finger", "table", "cap"}));
  const CycleSetup touching =
      withWorld(robots, worldOf({attached(objectOf("part", kBox), "hand", {"finger"})}));
  EXPECT_EQ(pairsOf(touching, "part"), Names{"base"});
  EXPECT_TRUE(
      std::any_of(touching.link_pairs.begin(), touching.link_pairs.end(),
                  [](const LinkPair& pair) { return pair.reason == PairReason::touch_link; }));
}

TEST(AddWorld, pairsAreSorted) {
  const CycleSetup setup =
      withWorld(gripperSetup(), worldOf({objectOf("a", kBox), attached(objectOf("b", kBox), "hand"),
                                         attached(objectOf("c", kBox), "finger")}));
  EXPECT_TRUE(std::is_sorted(setup.link_pairs.begin(), setup.link_pairs.end(),
                             [](const LinkPair& one, const LinkPair& other) {
                               return std::make_pair(one.a, one.b) <
                                      std::make_pair(other.a, other.b);
                             }));
}

/// The distance of two links, in the default pose.
PairDistance measured(const CycleSetup& setup, const std::string& a, const std::string& b) {
  CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::brute_force);
  const LinkPoses poses = posesAt(setup.model, defaultPositions(setup.model));
  learnPairs(setup, poses, buffers);
  runCycle(setup, poses, buffers);
  for (std::size_t i = 0; i < setup.checked.size(); ++i) {
    const CheckedLinkPair& pair = setup.checked[i];
    if (setup.model.link(pair.a).name == a && setup.model.link(pair.b).name == b &&
        buffers.events.closest[i] != kNone) {
      return buffers.distances.pairs[buffers.events.closest[i]];
    }
  }
  ADD_FAILURE() << a << " and " << b << " were not measured";
  return {};
}

TEST(AddWorld, everyKindOfObject_hasTheDistanceOfItsGeometry) {
  const CycleSetup robots = farSeeingSetup();
  auto wedge = std::make_shared<TriangleMesh>();
  wedge->vertices = {{-1, -1, -0.2}, {1, -1, -0.2}, {0, 1, -0.2}, {0, 0, -0.1}};
  wedge->triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  auto with_unused_vertex = std::make_shared<TriangleMesh>(*wedge);
  with_unused_vertex->vertices.emplace_back(0, 0, 0.2);
  const std::vector<std::pair<ObjectGeometry, double>> cases = {
      {SharedMesh(with_unused_vertex), 0.35},
      {Sphere{0.1}, 0.15},
      {Capsule{0.1, 0.1}, 0.05},
      {Box{{0.3, 0.2, 0.1}}, 0.15},
      {Cylinder{0.1, 0.4}, 0.15},
      {Cone{0.1, 0.2}, 0.15},
      {SharedMesh(wedge), 0.35},
      {Plane{{0, 0, 2}, -0.2}, 0.35}};
  for (const auto& [geometry, gap] : cases) {
    SCOPED_TRACE(geometry.index());
    const PairDistance distance = measured(
        withWorld(robots, worldOf({objectOf("it", geometry, at(0, 0, -0.3))})), "base", "it");
    EXPECT_NEAR(distance.measured.distance, gap, 1e-9);
    EXPECT_EQ(distance.quality,
              std::holds_alternative<Cone>(geometry) ? Quality::lower_bound : Quality::exact);
  }
}

TEST(AddWorld, aPlane_isExactFarFromItsOriginAndWhenEntered) {
  const CycleSetup robots = farSeeingSetup();
  const double tilt = 0.1;
  const Plane plane{{std::sin(tilt), 0, std::cos(tilt)}, -0.2};
  WorldObject floor = objectOf("floor", plane, at(-9e5, 0, 0));
  EXPECT_NEAR(measured(withWorld(robots, worldOf({objectOf("floor", plane)})), "base", "floor")
                  .measured.distance,
              0.15, 1e-9);
  floor.frame_from_object.translation.z() = 9e5 * std::tan(tilt);
  EXPECT_NEAR(measured(withWorld(robots, worldOf({floor})), "base", "floor").measured.distance,
              0.15, 1e-6);
  const PairDistance entered =
      measured(withWorld(robots, worldOf({objectOf("floor", Plane(), at(7e5, -3e5, 0.01))})),
               "base", "floor");
  EXPECT_NEAR(entered.measured.distance, -0.06, 1e-6);
  EXPECT_EQ(entered.quality, Quality::exact);
}

TEST(AddWorld, padding_isTakenFromTheDistance) {
  WorldObject table = objectOf("table", kBox, at(0, 0, -0.3));
  table.padding = 0.05;
  EXPECT_NEAR(
      measured(withWorld(farSeeingSetup(), worldOf({table})), "base", "table").measured.distance,
      0.1, 1e-9);
}

TEST(AddWorld, tooManyPairs_areRefusedWithTheMemoryThatTheyNeed) {
  CycleSetup robots = gripperSetup();
  robots.memory_limit = 50'000'000;
  std::vector<WorldObject> objects;
  for (int i = 0; i < 2000; ++i) {
    objects.push_back(
        attached(objectOf("o" + std::to_string(i), kBox), i % 2 == 0 ? "hand" : "finger"));
  }
  try {
    withWorld(robots, worldOf(objects));
    FAIL();
  } catch (const SetupError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find(" MB: its 2004 links with shapes make 1008006 pairs, of which"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("accepted: at most 50 MB (parameter memory_limit)"), std::string::npos)
        << text;
  }
}

TEST(AddWorld, attachedObjectsThatMoveTogether_takeNoRoomAsPairs) {
  CycleSetup robots = gripperSetup();
  robots.memory_limit = 100'000'000;
  std::vector<WorldObject> objects;
  for (int i = 0; i < 5000; ++i) {
    objects.push_back(attached(objectOf("o" + std::to_string(i), kBox), "hand"));
  }
  const CycleSetup setup = withWorld(robots, worldOf(objects));
  EXPECT_EQ(setup.link_pairs.size(), robots.link_pairs.size() + 4 * 5000);
  EXPECT_EQ(setup.checked.size(), robots.checked.size() + 2 * 5000);
}

TEST(AddWorld, whatWithoutPairsLeaves_sufficesForTheSameSetUp) {
  const CycleSetup robots = gripperSetup();
  for (const World& world : {World(), worldOf({attached(objectOf("part", kBox), "hand")})}) {
    const CycleSetup setup = withWorld(robots, world);
    const CycleSetup from_rest = withWorld(withoutPairs(robots), world);
    ASSERT_EQ(from_rest.table.size(), setup.table.size());
    for (std::size_t i = 0; i < setup.table.size(); ++i) {
      EXPECT_EQ(from_rest.table.pairs()[i].b, setup.table.pairs()[i].b);
      EXPECT_EQ(from_rest.element_pair_of[i], setup.element_pair_of[i]);
    }
  }
}

TEST(PrepareObjects, theSameShapes_arePreparedOnce) {
  const World world = worldOf({objectOf("a", kBox), objectOf("b", kBox)});
  const PreparedObjects first = prepareObjects(world, RefineGeometry::mesh, {});
  SetupReport report;
  WorldObject moved = named("a");
  moved.frame_from_object = at(1, 2, 3);
  const World later = applyChanges(world,
                                   {{ChangeKind::move, {moved}, true},
                                    {ChangeKind::remove, {named("b")}, true},
                                    {ChangeKind::add, {objectOf("b", kBox)}, true}},
                                   armPlaces(), report);
  ASSERT_TRUE(report.errors.empty());
  const PreparedObjects second = prepareObjects(later, RefineGeometry::mesh, first);
  EXPECT_EQ(second.at("a"), first.at("a"));
  EXPECT_NE(second.at("b"), first.at("b"));
}

}  // namespace
}  // namespace collision_monitor::test
