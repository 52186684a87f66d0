// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/world/held_back.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "unit/ros_edge/world_scene.h"

namespace collision_monitor::test {
namespace {

/// The sliding robot with a table. Until a missing robot comes, gripper and rack are held back.
class HeldBack : public testing::Test {
 protected:
  HeldBack() {
    auto made = std::make_shared<MonitorSetup>(
        *slidingSetupWith({objectOf("table", Sphere{0.1}, at(0, 0, 9))}));
    made->held_back = {attached(objectOf("gripper", Sphere{0.1}), "other/hand"),
                       attached(objectOf("rack", Sphere{0.1}), "other/base")};
    setup_ = std::move(made);
  }

  /// @return the faults
  std::vector<std::string> apply(const std::vector<ObjectChange>& changes) {
    SetupReport report;
    const World before = worldBefore(changes, *setup_, held_back_);
    KnownPlaces places = placesOf(setup_->robots->model, setup_->world_frame);
    places.waiting = {"rack"};
    world_ = applyChanges(before, changes, places, report);
    return textsOf(report.errors);
  }
  std::vector<std::string> heldBack() const {
    std::vector<std::string> names;
    for (const WorldObject& object : held_back_) {
      names.push_back(object.name);
    }
    return names;
  }

  std::shared_ptr<const MonitorSetup> setup_;
  World world_;
  std::vector<WorldObject> held_back_;
};

TEST_F(HeldBack, objectThatIsRemoved_doesNotComeBack) {
  EXPECT_EQ(apply({{ChangeKind::remove, {named("gripper")}, true}}), std::vector<std::string>());
  EXPECT_EQ(heldBack(), std::vector<std::string>{"rack"});
  EXPECT_EQ(world_.objects.size(), 1U);
}

TEST_F(HeldBack, nameOfAWaitingObject_isTakenUntilItIsRemoved) {
  const WorldObject rack = objectOf("rack", Sphere{0.2}, at(0, 0, 8));
  EXPECT_THAT(apply({{ChangeKind::add, {rack}, true}}),
              testing::ElementsAre(testing::HasSubstr(
                  "'rack': the name of an object that waits for a robot; accepted: other names; "
                  "remove ends its wait")));
  EXPECT_THAT(apply({{ChangeKind::move, {named("rack")}, true}}),
              testing::ElementsAre(testing::HasSubstr("'rack': an object that waits for a robot")));
  const WorldObject gripper = objectOf("gripper", Sphere{0.2}, at(0, 0, 8));
  EXPECT_EQ(
      apply({{ChangeKind::remove, {named("gripper")}, true}, {ChangeKind::add, {gripper}, true}}),
      std::vector<std::string>());
  EXPECT_EQ(heldBack(), std::vector<std::string>{"rack"});
  EXPECT_EQ(world_.objects.size(), 2U);
}

TEST_F(HeldBack, otherChanges_leaveThem) {
  EXPECT_EQ(apply({{ChangeKind::remove, {named("table")}, true}}), std::vector<std::string>());
  EXPECT_EQ(heldBack(), (std::vector<std::string>{"gripper", "rack"}));
  EXPECT_TRUE(world_.objects.empty());
  EXPECT_EQ(apply({{ChangeKind::remove, {named("nobody")}, true}}).size(), 1U);
  EXPECT_EQ(apply({{ChangeKind::clear, {}, true}}), std::vector<std::string>());
  EXPECT_TRUE(held_back_.empty());
}

}  // namespace
}  // namespace collision_monitor::test
