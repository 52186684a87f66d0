// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "support/robots/world_objects.h"

namespace collision_monitor::test {
namespace {

using Texts = std::vector<std::string>;

const Box kBox{{0.1, 0.2, 0.3}};

std::vector<std::string> namesOf(const World& world) {
  std::vector<std::string> names;
  for (const auto& [name, object] : world.objects) {
    names.push_back(name);
  }
  return names;
}

Texts faultsOf(const World& world, const std::vector<ObjectChange>& changes,
               const KnownPlaces& places = armPlaces()) {
  SetupReport report;
  const World after = applyChanges(world, changes, places, report);
  EXPECT_EQ(after.objects, world.objects) << "a change with a fault changed something";
  return textsOf(report.errors);
}

World changed(const World& world, const std::vector<ObjectChange>& changes,
              const KnownPlaces& places = armPlaces()) {
  SetupReport report;
  World after = applyChanges(world, changes, places, report);
  EXPECT_EQ(textsOf(report.errors), Texts());
  return after;
}

TEST(ApplyChanges, addMoveRemoveAndClear_changeWhatTheyName) {
  World world = changed({}, {{ChangeKind::add, {objectOf("b", kBox), objectOf("a", kBox)}, true}});
  EXPECT_EQ(namesOf(world), (Texts{"a", "b"}));
  EXPECT_EQ(world.objects.at("a")->frame, "map");
  WorldObject moved = named("a", "/camera");
  moved.frame_from_object = at(1, 2, 3);
  world = changed(world, {{ChangeKind::move, {moved}, true}});
  EXPECT_EQ(world.objects.at("a")->frame, "camera");
  EXPECT_EQ(world.objects.at("a")->frame_from_object.translation.z(), 3.0);
  world = changed(world, {{ChangeKind::move, {named("a")}, true}});
  EXPECT_EQ(world.objects.at("a")->frame, "camera") << "an empty frame keeps the frame";
  world = changed(world, {{ChangeKind::remove, {named("b")}, true}});
  EXPECT_EQ(namesOf(world), Texts{"a"});
  world = changed(world, {{ChangeKind::replace_all, {objectOf("c", kBox)}, true}});
  EXPECT_EQ(namesOf(world), Texts{"c"});
  EXPECT_TRUE(changed(world, {{ChangeKind::clear, {}, true}}).objects.empty());
}

TEST(ApplyChanges, laterChanges_seeWhatEarlierOnesDid) {
  const World world = changed({}, {{ChangeKind::add, {objectOf("a", kBox)}, true},
                                   {ChangeKind::attach, {named("a", "hand")}, true},
                                   {ChangeKind::clear, {}, true},
                                   {ChangeKind::add, {objectOf("a", Sphere{1.0})}, true}});
  EXPECT_FALSE(world.objects.at("a")->is_attached);
}

TEST(ApplyChanges, attachAndDetachWhereItStands_keepThePlaceInTheWorld) {
  KnownPlaces places = armPlaces();
  const Pose map_from_hand = at(0, 0, 1);
  places.find_pose = [&](const std::string& parent, const std::string& child) {
    EXPECT_TRUE((parent == "map" && child == "hand") || (parent == "hand" && child == "map"));
    return std::optional<Pose>(parent == "map" ? map_from_hand : inverse(map_from_hand));
  };
  World world = worldOf({objectOf("part", kBox, at(1, 0, 1))});
  WorldObject grasped = named("part", "hand");
  grasped.touch_links = {"finger"};
  world = changed(world, {{ChangeKind::attach, {grasped}, false}}, places);
  const WorldObject& held = *world.objects.at("part");
  EXPECT_TRUE(held.is_attached);
  EXPECT_EQ(held.frame, "hand");
  EXPECT_EQ(held.touch_links, Texts{"finger"});
  EXPECT_TRUE(held.frame_from_object.translation.isApprox(Eigen::Vector3d(1, 0, 0)));
  world = changed(world, {{ChangeKind::detach, {named("part")}, true}}, places);
  EXPECT_FALSE(world.objects.at("part")->is_attached);
  EXPECT_TRUE(world.objects.at("part")->touch_links.empty());
  EXPECT_TRUE(
      world.objects.at("part")->frame_from_object.translation.isApprox(Eigen::Vector3d(1, 0, 1)));
}

TEST(ApplyChanges, everyFaultOfAList_isNamedWithItsPlaceAndNothingChanges) {
  WorldObject crooked = objectOf("crooked", kBox);
  crooked.frame_from_object.rotation.setZero();
  WorldObject padded = objectOf("padded", kBox);
  padded.padding = -0.1;
  const World world = worldOf({objectOf("table", kBox)});
  EXPECT_EQ(
      faultsOf(world, {{ChangeKind::add,
                        {objectOf("table", kBox), objectOf("hand", kBox), crooked, padded},
                        true},
                       {ChangeKind::remove, {named("tabl")}, true},
                       {ChangeKind::attach, {attached(named("table"), "handd", {"thumb"})}, true},
                       {ChangeKind::move, {named("table", "nowhere")}, true}}),
      (Texts{
          "change 1 (add), object 'table': this name twice; accepted: names that no other object "
          "has; move and remove change objects",
          "change 1 (add), object 'hand': the name of a link; accepted: a name that no link has",
          "change 1 (add), object 'crooked': an orientation that is no rotation; accepted: a unit "
          "quaternion",
          "change 1 (add), object 'padded': padding -0.1 m; accepted: from 0 to 1000 m",
          "change 2 (remove), object 'tabl': no object of this name, did you mean 'table'?; "
          "accepted: one of crooked, hand, padded and table",
          "change 3 (attach), object 'table': link 'handd', which is unknown, did you mean "
          "'hand'?; "
          "accepted: a link of the robots, by its name in messages",
          "change 3 (attach), object 'table': touch link 'thumb', which is unknown; accepted: a "
          "link of the robots, by its name in messages",
          "change 4 (move), object 'table': frame 'nowhere', which is unknown; accepted: a frame "
          "that tf knows, a link's frame or the world frame 'map'"}));
}

TEST(ApplyChanges, shapesThatCannotBe_areNamed) {
  auto torn = std::make_shared<TriangleMesh>();
  torn->vertices = {{0, 0, 0}, {1, 0, 0}, {std::nan(""), 0, 0}};
  torn->triangles = {{0, 1, 2}};
  auto loose = std::make_shared<TriangleMesh>(*torn);
  loose->vertices[2] = {0, 1, 0};
  loose->triangles = {{0, 1, 7}};
  const Texts faults =
      faultsOf({}, {{ChangeKind::add,
                     {objectOf("a", Plane{{0, 0, 0}, 0.0}), objectOf("b", SharedMesh(torn)),
                      objectOf("c", SharedMesh(loose)), objectOf("d", Box{{0.0, 1.0, -1.0}}),
                      objectOf("e", Sphere{std::nan("")}), objectOf("f", SharedMesh()), named("g")},
                     true}});
  EXPECT_EQ(faults,
            (Texts{"change 1 (add), object 'a', shape 1: plane normal (0, 0, 0); accepted: a "
                   "direction: three numbers, not all 0",
                   "change 1 (add), object 'b', shape 1: mesh: vertex 2 is (nan, 0, 0); "
                   "coordinates up to 1e+06 are accepted",
                   "change 1 (add), object 'c', shape 1: mesh: triangle 0 names vertex 7; there "
                   "are 3, counted from 0",
                   "change 1 (add), object 'd', shape 1: box size along x 0 m; accepted: a length "
                   "greater than 0, up to 1e+06 m",
                   "change 1 (add), object 'd', shape 1: box size along z -2 m; accepted: a length "
                   "greater than 0, up to 1e+06 m",
                   "change 1 (add), object 'e', shape 1: sphere radius nan m; accepted: a length "
                   "greater than 0, up to 1e+06 m",
                   "change 1 (add), object 'f', shape 1: a mesh without triangles; accepted: at "
                   "least one triangle",
                   "change 1 (add), object 'g': no shapes; accepted: at least one shape"}));
}

TEST(ApplyChanges, misusedChanges_areNamed) {
  const World world = worldOf({objectOf("table", kBox), attached(objectOf("tool", kBox), "hand")});
  EXPECT_EQ(
      faultsOf(world, {{ChangeKind::clear, {named("table")}, true}, {ChangeKind::add, {}, true}}),
      (Texts{
          "change 1 (clear): a list of objects; accepted: an empty list, for all objects; remove "
          "takes names",
          "change 2 (add): no objects; accepted: at least one"}));
  EXPECT_EQ(faultsOf(world, {{ChangeKind::detach, {named("table")}, true},
                             {ChangeKind::move, {named("tool", "map")}, true},
                             {ChangeKind::attach, {named("table", "hand")}, false}}),
            (Texts{"change 1 (detach), object 'table': an object that is not attached; accepted: "
                   "an attached object; move places others",
                   "change 2 (move), object 'tool': frame 'map' for an object attached to link "
                   "'hand'; accepted: no frame, for a pose in that link; detach sets the object "
                   "free",
                   "change 3 (attach), object 'table': the pose of 'map' in 'hand' is not known "
                   "now; accepted: frames that tf joins with fresh data, or attach with a pose"}));
}

TEST(ApplyChanges, aMillionObjects_areRefusedWithOneFault) {
  ObjectChange change{ChangeKind::add, {}, true};
  for (int i = 0; i < 1'000'000; ++i) {
    change.objects.push_back(named("box_" + std::to_string(i)));
    change.objects.back().shapes =
        change.objects.front().shapes ? change.objects.front().shapes : objectOf("", kBox).shapes;
  }
  const Texts faults = faultsOf({}, {change});
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0],
            "change 1 (add), object 'box_20000': more than 20000 objects; accepted: at most 20000");
}

TEST(ApplyChanges, manyFaults_areListedUpToAHundred) {
  ObjectChange change{ChangeKind::remove, {}, true};
  for (int i = 0; i < 1000; ++i) {
    change.objects.push_back(named("box_" + std::to_string(i)));
  }
  const Texts faults = faultsOf({}, {change});
  ASSERT_EQ(faults.size(), 101U);
  EXPECT_EQ(faults[100],
            "changes: more faults than are listed here; accepted: changes without a fault");
}

TEST(KnownPlaces, linkOfARobotThatIsThere_doesNotCome) {
  KnownPlaces places;
  places.links = {"left/base", "cell/right/base", "lone_base"};
  EXPECT_FALSE(places.mayCome("up/base"));  // no robot is to come
  places.awaits_links = true;
  EXPECT_TRUE(places.mayCome("up/base"));
  EXPECT_TRUE(places.mayCome("right/base"));
  EXPECT_TRUE(places.mayCome("other_base"));
  EXPECT_FALSE(places.mayCome("left/bsae"));
  EXPECT_FALSE(places.mayCome("cell/right/bsae"));
}

}  // namespace
}  // namespace collision_monitor::test
