// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/robots/late_robots.h"

#include <gtest/gtest.h>

#include "collision_monitor/model/problems.h"
#include "ros_edge/robots/missing.h"
#include "two_arms.h"
#include "unit/ros_edge/world_scene.h"

namespace collision_monitor::test {
namespace {

/// The left arm is watched, and the right one comes. What is not tried is counted.
class LateRobotsTest : public TwoArms {
 protected:
  LateRobotsTest() {
    const auto first = std::make_shared<MonitorSetup>();
    first->descriptions = {descriptions_[0]};
    first->robots = std::make_shared<CycleSetup>(
        withoutPairs(buildSetup(first->descriptions, textLoader({}), SetupOptions())));
    first->setup = addWorld(*first->robots, {}, {}, "cell");
    first->world_frame = "cell";
    first->listed = {{"left", RobotId{0}, "", false},
                     {"right", std::nullopt, "no URDF in parameter /right", false}};
    current_ = first;
  }

  LateHooks hooks() {
    LateHooks hooks;
    hooks.current_setup = [this] { return current_; };
    hooks.find = [this](const MonitorSetup& former, std::optional<std::size_t> only, SetupReport&) {
      return find(former, only);
    };
    hooks.build = [this](LoadedRobots come, const MonitorSetup& former, SetupReport& report) {
      ++builds_;
      return buildLate(std::move(come), former, report);
    };
    hooks.take_in = [this](const MonitorSetup& late, const MonitorSetup& former) {
      ++joins_;
      current_ = takeIn(late, former);
    };
    hooks.tell_missing = [this](const MonitorSetup& former, const auto& listed) {
      ++told_;
      current_ = withMissing(former, listed);
    };
    hooks.log_error = [](const std::string&) {};
    return hooks;
  }

  LoadedRobots find(const MonitorSetup& former, std::optional<std::size_t> only) const {
    LoadedRobots found{former.descriptions, former.listed};
    for (std::size_t i = 1; i < found.listed.size(); ++i) {
      const RobotDescription& late = i == 1 ? right_ : third_;
      if (former.listed[i].id || only.value_or(i) != i) {
        continue;
      }
      if (late.urdf_xml.empty()) {
        found.listed[i].missing = "no URDF in parameter /" + found.listed[i].name;
      } else {
        found.listed[i].id = idAt<RobotId>(found.descriptions.size());
        found.descriptions.push_back(late);
      }
    }
    return found;
  }
  void look(int times = 1) {
    for (int i = 0; i < times; ++i) {
      late_.look();
    }
  }
  void breakRight() {
    right_ = descriptions_[1];
    right_.urdf_xml = "<robot name='right'><link/></robot>";
  }
  void listThird() {
    const auto three = std::make_shared<MonitorSetup>(*current_);
    three->listed.push_back({"third", std::nullopt, "no URDF in parameter /third", false});
    current_ = three;
  }
  void addObject(const std::string& name) {
    const World world = worldOf({objectOf(name, Sphere{0.1}, at(0, 0, 9))},
                                placesOf(current_->robots->model, current_->world_frame));
    current_ = changeWorld(*current_, world, {});
  }

  RobotDescription right_;  ///< the parameter; without text: it has not come
  RobotDescription third_;  ///< the same of a robot that only some tests list
  std::shared_ptr<const MonitorSetup> current_;
  int builds_{0};
  int joins_{0};
  int told_{0};
  LateRobots late_{hooks()};
};

TEST_F(LateRobotsTest, robotThatComes_isTakenInOnce) {
  look(3);
  EXPECT_EQ(builds_ + joins_ + told_, 0) << "it has not come";
  addObject("post");
  right_ = descriptions_[1];
  look(3);
  EXPECT_EQ(builds_, 1);
  EXPECT_EQ(joins_, 1);
  ASSERT_TRUE(current_->listed[1].id);
  EXPECT_TRUE(current_->setup.model.findLink("right/hand"));
  EXPECT_EQ(current_->world.objects.count("post"), 1U);
}

TEST_F(LateRobotsTest, objectsOfASetupThatStays_areNotPreparedAnew) {
  addObject("post");
  const auto before = current_->prepared.at("post");
  right_ = descriptions_[1];
  look();
  EXPECT_EQ(current_->prepared.at("post"), before);
}

TEST_F(LateRobotsTest, faultyRobot_isNotBuiltAgainUntilItsTextChanges) {
  breakRight();
  look(5);
  EXPECT_EQ(builds_, 1);
  addObject("post");
  look(2);
  EXPECT_EQ(builds_, 1) << "objects change nothing of the fault";
  right_ = descriptions_[1];
  look();
  EXPECT_EQ(builds_, 2);
  EXPECT_TRUE(current_->listed[1].id);
}

TEST_F(LateRobotsTest, faultyRobot_isToldAsSuchUntilItsTextIsGone) {
  breakRight();
  look(3);
  EXPECT_EQ(told_, 1);
  EXPECT_EQ(current_->listed[1].missing.rfind("its URDF has come, but it cannot be taken in: ", 0),
            0U)
      << current_->listed[1].missing;
  right_.urdf_xml.clear();
  look(3);
  EXPECT_EQ(told_, 2);
  EXPECT_EQ(current_->listed[1].missing, "no URDF in parameter /right");
}

TEST_F(LateRobotsTest, faultyRobotThatMayBeAbsent_stopsTheOthers) {
  const auto may_be = std::make_shared<MonitorSetup>(*current_);
  may_be->listed[1].may_be_absent = true;
  current_ = may_be;
  look();
  EXPECT_FALSE(isAnyAwaited(*current_));
  breakRight();
  look(2);
  EXPECT_TRUE(isAnyAwaited(*current_)) << "it is there";
  right_.urdf_xml.clear();
  look(2);
  EXPECT_FALSE(isAnyAwaited(*current_));
}

TEST_F(LateRobotsTest, robotThatAnObjectKeepsOut_comesInWithoutBeingBuiltAgain) {
  addObject("right/hand");
  right_ = descriptions_[1];
  look(4);
  EXPECT_EQ(builds_, 1);
  EXPECT_LE(joins_, 2) << "telling of the fault is a change of the set-up, too";
  EXPECT_FALSE(current_->listed[1].id);
  current_ = changeWorld(*current_, World(), {});
  look();
  EXPECT_EQ(builds_, 1);
  EXPECT_TRUE(current_->listed[1].id);
}

TEST_F(LateRobotsTest, nameTwice_ofAnObjectThatWaits_isAFault) {
  listThird();
  addObject("tool");
  const auto twice = std::make_shared<MonitorSetup>(*current_);
  twice->held_back = {attached(objectOf("tool", Sphere{0.1}), "third/hand")};
  current_ = twice;
  right_ = descriptions_[1];
  look(2);
  EXPECT_FALSE(current_->listed[1].id);
  EXPECT_NE(current_->listed[1].missing.find("the name of an object that waits"), std::string::npos)
      << current_->listed[1].missing;
}

TEST_F(LateRobotsTest, faultOfOneRobot_keepsNoOtherAway) {
  listThird();
  breakRight();
  third_ = descriptions_[1];
  third_.tf_prefix = "third";
  look(3);
  EXPECT_FALSE(current_->listed[1].id);
  EXPECT_NE(current_->listed[1].missing.find("without name"), std::string::npos)
      << current_->listed[1].missing;
  ASSERT_TRUE(current_->listed[2].id);
  EXPECT_TRUE(current_->setup.model.findLink("third/hand"));
  const int builds = builds_;
  look(3);
  EXPECT_EQ(builds_, builds);
}

TEST_F(LateRobotsTest, eachFaultyRobot_isToldItsOwnFault) {
  listThird();
  breakRight();
  third_ = descriptions_[1];
  third_.urdf_xml = "<robot name='third'>";
  look(2);
  EXPECT_NE(current_->listed[1].missing.find("without name"), std::string::npos)
      << current_->listed[1].missing;
  EXPECT_NE(current_->listed[2].missing.find("cannot be parsed"), std::string::npos)
      << current_->listed[2].missing;
}

TEST_F(LateRobotsTest, nameOfARuleThatMatchesNothing_isToldOnceAllHaveCome) {
  auto made = partsOf(*current_);
  SetupReport report;
  const std::vector<PairRule> rules =
      readPairRules({"rules.yaml", "- {a: left/hand, b: 'rihgt/*', check: false}"},
                    current_->setup.model, {}, IdleRule::is_accepted, report);
  made->setup = withPairRules(current_->setup, current_->setup.limits, rules, report);
  made->rule_ends = {kLasts};
  current_ = made;
  right_ = descriptions_[1];
  look();
  ASSERT_TRUE(current_->listed[1].id);
  std::vector<std::string> texts;
  for (const Problem& warning : current_->setup.report.warnings) {
    texts.push_back(toString(warning));
  }
  ASSERT_EQ(texts.size(), 1U);
  EXPECT_EQ(texts[0].rfind("rules.yaml line 1, rule 1: ", 0), 0U) << texts[0];
  EXPECT_NE(texts[0].find("rihgt/*"), std::string::npos) << texts[0];
}

}  // namespace
}  // namespace collision_monitor::test
