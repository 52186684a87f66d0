// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "collision_monitor/model/srdf_reader.h"
#include "support/robots/urdf_text.h"

namespace collision_monitor {
namespace {

using test::jointXml;
using test::robotXml;

/// "name: a b" for each group of a robot whose root carries the branches a-b-c and x-y.
std::vector<std::string> groupsOf(const std::string& srdf_xml, const std::string& prefix = "") {
  RobotDescription description = test::describeText(
      robotXml("<link name='root'/><link name='a'/><link name='b'/><link name='c'/><link name='x'/>"
               "<link name='y'/>" +
               jointXml("ra", "fixed", "root", "a") + jointXml("ab", "continuous", "a", "b") +
               jointXml("bc", "continuous", "b", "c") + jointXml("rx", "continuous", "root", "x") +
               jointXml("xy", "continuous", "x", "y")));
  description.srdf_xml = robotXml(srdf_xml);
  description.tf_prefix = prefix;
  SetupReport report;
  const RobotModel model = readRobots({description}, test::textLoader({}), report);
  SetupReport srdf_report;
  std::vector<std::string> texts;
  const SrdfPairs srdf = readSrdf(description, RobotId{0}, model, srdf_report);
  for (std::size_t i = 0; i < srdf.groups.size(); ++i) {
    texts.push_back(srdf.groups[i].name + ":");
    for (const LinkId link : linksOf(srdf.groups, i, model)) {
      texts.back() += " " + model.link(link).name;
    }
  }
  for (const Problem& warning : srdf_report.warnings) {
    texts.push_back(toString(warning));
  }
  EXPECT_TRUE(srdf_report.errors.empty());
  return texts;
}

using Texts = std::vector<std::string>;

TEST(SrdfGroups, linksAndJoints_holdLinksAndChildLinks) {
  EXPECT_EQ(groupsOf("<group name='g'><link name='/a'/><joint name='xy'/></group>"),
            Texts{"g: a y"});
  EXPECT_EQ(groupsOf("<group name='g'><link name='a'/><joint name='xy'/></group>", "left"),
            Texts{"g: left/a left/y"});
}

TEST(SrdfGroups, virtualJoint_standsForTheLinkItMoves) {
  EXPECT_EQ(groupsOf("<virtual_joint name='v' type='fixed' parent_frame='w' child_link='root'/>"
                     "<group name='g'><joint name='v'/></group>"),
            Texts{"g: root"});
}

TEST(SrdfGroups, chain_leavesItsBaseOut) {
  EXPECT_EQ(groupsOf("<group name='g'><chain base_link='root' tip_link='b'/></group>"),
            Texts{"g: a b"});
  EXPECT_EQ(groupsOf("<group name='g'><chain base_link='b' tip_link='b'/></group>"), Texts{"g:"});
}

TEST(SrdfGroups, chainOverTwoBranches_holdsTheLinkWhereTheyMeet) {
  EXPECT_EQ(groupsOf("<group name='g'><chain base_link='b' tip_link='y'/></group>"),
            Texts{"g: root a b x y"});
  EXPECT_EQ(groupsOf("<group name='g'><chain base_link='c' tip_link='a'/></group>"),
            Texts{"g: a b c"});
}

TEST(SrdfGroups, subgroups_mayStandAfterAndInACircle) {
  EXPECT_EQ(groupsOf("<group name='all'><group name='one'/><link name='x'/></group>"
                     "<group name='one'><link name='a'/><group name='all'/></group>"),
            (Texts{"all: a x", "one: a x"}));
}

TEST(SrdfGroups, unknownMembers_areOneWarningAndLeftOut) {
  EXPECT_EQ(groupsOf("<group name='g'><link name='a'/><link name='q'/><joint name='aq'/>"
                     "<group name='h'/><chain base_link='a' tip_link='z'/></group>"),
            (Texts{"g: a",
                   "test.urdf (SRDF): groups with unknown members: link 'q' (line 2), joint 'aq' "
                   "(line 2), group 'h' (line 2) and link 'z' (line 2); the robot lacks them; "
                   "they are left out"}));
}

// Groups in groups, of which each adds a link: what a group holds is found when it is asked for, or
// all of them together would hold the square of links.
TEST(SrdfGroups, chainOfTwentyThousand_isHeldAsItStandsInTheFile) {
  constexpr std::size_t kCount = 20'000;
  std::string links = "<link name='l0'/>";
  std::string groups;
  for (std::size_t i = 0; i < kCount; ++i) {
    const std::string number = std::to_string(i);
    const std::string next = std::to_string(i + 1);
    links += "<link name='l" + next + "'/>" +
             jointXml("j" + number, "continuous", "l" + number, "l" + next);
    groups += "<group name='g" + number + "'><link name='l" + number + "'/>" +
              (i + 1 < kCount ? "<group name='g" + next + "'/>" : "") + "</group>";
  }
  RobotDescription description = test::describeText(robotXml(links));
  description.srdf_xml = robotXml(groups + "<group name='arm'><chain base_link='l0' tip_link='l" +
                                  std::to_string(kCount) + "'/></group>");
  SetupReport report;
  const RobotModel model = readRobots({description}, test::textLoader({}), report);
  const SrdfPairs srdf = readSrdf(description, RobotId{0}, model, report);
  EXPECT_TRUE(report.errors.empty());
  std::size_t held = 0;
  for (const LinkGroup& group : srdf.groups) {
    held += group.links.size();
  }
  EXPECT_EQ(held, kCount);
  EXPECT_EQ(linksOf(srdf.groups, 0, model).size(), kCount);
  EXPECT_EQ(linksOf(srdf.groups, kCount - 1, model).size(), 1U);
  EXPECT_EQ(linksOf(srdf.groups, kCount, model).size(), kCount) << "the chain, without its base";
}

}  // namespace
}  // namespace collision_monitor
