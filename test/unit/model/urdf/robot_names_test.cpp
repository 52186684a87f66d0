// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/robots/urdf_text.h"

namespace collision_monitor {
namespace {

using test::jointXml;
using test::readText;
using test::ReadText;
using test::robotXml;

ReadText readWithPrefix(const std::string& prefix, const std::string& xml) {
  RobotDescription description = test::describeText(xml);
  description.tf_prefix = prefix;
  ReadText read;
  read.model = readRobots({description}, test::textLoader({}), read.report);
  EXPECT_EQ(read.errors(), std::vector<std::string>());
  return read;
}

const std::string kTwoLinks =
    robotXml("<link name='a'/><link name='b'/>" + jointXml("j", "continuous", "a", "b"));

TEST(RobotNames, prefix_standsBeforeLinksFramesAndJoints) {
  for (const char* prefix : {"left", "/left", "left/", "/left/"}) {
    const RobotModel model = readWithPrefix(prefix, kTwoLinks).model;
    EXPECT_EQ(model.links.at(1).name, "left/b") << prefix;
    EXPECT_EQ(model.links.at(1).frame, "left/b") << prefix;
    EXPECT_EQ(model.joints.at(0).name, "left/j") << prefix;
    EXPECT_EQ(model.robots.at(0).tf_prefix, "left") << prefix;
  }
}

TEST(RobotNames, nameThatHasThePrefix_doesNotGetItTwice) {
  EXPECT_EQ(readWithPrefix("left", robotXml("<link name='left/a'/>")).model.links.at(0).name,
            "left/a");
}

TEST(RobotNames, linksThatThePrefixMakesAlike_areAnError) {
  RobotDescription robot = test::describeText(
      robotXml("<link name='left/a'/><link name='a'/>" + jointXml("j", "fixed", "left/a", "a")));
  robot.tf_prefix = "left";
  SetupReport report;
  readRobots({robot}, test::textLoader({}), report);
  ASSERT_EQ(report.errors.size(), 1u);
  EXPECT_EQ(toString(report.errors[0]),
            "test.urdf: link 'left/a' is also another link of test.urdf; accepted: names that "
            "differ with their tf prefix, too");
}

TEST(RobotNames, leadingSlash_isDroppedAndItsFrameHasNoPrefix) {
  const RobotModel model = readWithPrefix("left", robotXml("<link name='/a'/><link name='b'/>" +
                                                           jointXml("j", "fixed", "a", "/b")))
                               .model;
  EXPECT_EQ(model.links.at(0).name, "left/a");
  EXPECT_EQ(model.links.at(0).frame, "a");
  EXPECT_EQ(model.links.at(1).frame, "left/b");
}

TEST(RobotNames, links_standParentFirstWhateverTheirOrder) {
  const ReadText read = readText(
      robotXml("<link name='tip'/><link name='right'/><link name='base'/><link name='left'/>" +
               jointXml("j0", "fixed", "left", "tip") + jointXml("j1", "fixed", "base", "left") +
               jointXml("j2", "fixed", "base", "right")));
  std::vector<std::string> names;
  for (const Link& link : read.model.links) {
    names.push_back(link.name);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"base", "left", "tip", "right"}));
  EXPECT_EQ(read.model.robots.at(0).link_count, 4u);
  EXPECT_EQ(read.model.robots.at(0).joint_count, 3u);
  EXPECT_FALSE(read.model.links[0].parent_joint);
  for (std::size_t i = 1; i < read.model.links.size(); ++i) {
    const Joint& joint = read.model.joint(read.model.links[i].parent_joint.value());
    EXPECT_EQ(index(joint.child), i);
    EXPECT_LT(index(joint.parent), i);
  }
}

TEST(RobotNames, twoRobots_areOneForest) {
  RobotDescription left = test::describeText(kTwoLinks);
  RobotDescription right = left;
  left.tf_prefix = "left";
  right.tf_prefix = "right";
  SetupReport report;
  const RobotModel model = readRobots({left, right}, test::textLoader({}), report);
  ASSERT_TRUE(report.errors.empty());
  EXPECT_EQ(model.robots.at(1).first_link, 2u);
  EXPECT_EQ(index(model.robots.at(1).root), 2u);
  EXPECT_EQ(index(model.links.at(3).robot), 1u);
  EXPECT_EQ(model.joints.at(1).first_variable, 1u);
  EXPECT_EQ(index(model.findLink("right/b").value()), 3u);
  EXPECT_EQ(index(model.findJoint("right/j").value()), 1u);
  EXPECT_FALSE(model.findLink("b"));
}

TEST(RobotNames, twoRobotsWithTheSameNames_isAnError) {
  SetupReport report;
  const RobotDescription robot = test::describeText(robotXml("<link name='a'/>"));
  const RobotModel model = readRobots({robot, robot}, test::textLoader({}), report);
  ASSERT_EQ(report.errors.size(), 1u);
  EXPECT_EQ(toString(report.errors[0]),
            "test.urdf: link 'a' is also a link of test.urdf; accepted: a tf prefix for each "
            "robot, so that names differ");
  EXPECT_TRUE(model.links.empty());
}

TEST(RobotNames, jointsOfTwoRobotsWithTheSameName_areAnErrorIfTheyMove) {
  const auto robot = [](const std::string& side, const std::string& type) {
    return test::describeText(robotXml("<link name='" + side + "_a'/><link name='" + side +
                                       "_b'/>" + jointXml("j", type, side + "_a", side + "_b")));
  };
  SetupReport report;
  readRobots({robot("left", "fixed"), robot("right", "continuous")}, test::textLoader({}), report);
  EXPECT_TRUE(report.errors.empty());
  readRobots({robot("left", "revolute"), robot("right", "continuous")}, test::textLoader({}),
             report);
  ASSERT_EQ(report.errors.size(), 1u);
  EXPECT_EQ(toString(report.errors[0]),
            "test.urdf: joint 'j' is also a joint of test.urdf; accepted: a tf prefix for each "
            "robot, so that names differ");
}

TEST(RobotNames, linksThatAreSeenAndNotChecked_areOneWarning) {
  const std::string visual = "<visual><geometry><sphere radius='1'/></geometry></visual>";
  EXPECT_EQ(readText(robotXml("<link name='a'>" + visual + "</link><link name='b'>" + visual +
                              "</link>" + jointXml("j", "fixed", "a", "b")))
                .warnings(),
            std::vector<std::string>{"test.urdf: links without collision geometry: link 'a'; link "
                                     "'b'; nothing is checked of them"});
}

/// Tools and sensors have them; a warning that never ends hides those that matter.
TEST(RobotNames, linksThatAreFramesAlone_areNoWarning) {
  EXPECT_TRUE(readText(kTwoLinks).warnings().empty());
}

TEST(RobotNames, longChain_isRead) {
  std::string elements = "<link name='l0'/>";
  for (int i = 1; i < 20000; ++i) {
    const std::string parent = "l" + std::to_string(i - 1);
    const std::string child = "l" + std::to_string(i);
    elements += "<link name='" + child + "'/>" + jointXml("j" + child, "fixed", parent, child);
  }
  EXPECT_EQ(readText(robotXml(elements)).model.links.size(), 20000u);
}

}  // namespace
}  // namespace collision_monitor
