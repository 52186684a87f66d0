// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/model/srdf_reader.h"

#include <gtest/gtest.h>

#include "support/urdf_text.h"

namespace collision_monitor {
namespace {

using test::jointXml;
using test::robotXml;

struct ReadSrdf {
  RobotModel model;
  SrdfPairs pairs;
  std::vector<std::string> errors;
  std::vector<std::string> warnings;
};

/// Reads the SRDF lines for a robot of the links a, b, c with the given prefix.
ReadSrdf read(const std::string& srdf_xml, const std::string& prefix = "", bool is_strict = false) {
  RobotDescription description = test::describeText(
      robotXml("<link name='a'/><link name='b'/><link name='c'/>" +
               jointXml("j", "continuous", "a", "b") + jointXml("k", "continuous", "b", "c")));
  description.srdf_xml = srdf_xml;
  description.srdf_source = "test.srdf";
  description.is_strict = is_strict;
  description.tf_prefix = prefix;
  ReadSrdf result;
  SetupReport urdf_report;
  result.model = readRobots({description}, test::textLoader({}), urdf_report);
  SetupReport report;
  result.pairs = readSrdf(description, RobotId{0}, result.model, report);
  for (const Problem& problem : report.errors) {
    result.errors.push_back(toString(problem));
  }
  for (const Problem& problem : report.warnings) {
    result.warnings.push_back(toString(problem));
  }
  return result;
}

std::string pairText(const ReadSrdf& srdf, const SrdfPairs::Entry& entry) {
  return srdf.model.link(entry.a).name + " " + srdf.model.link(entry.b).name + " " + entry.reason;
}

TEST(SrdfReader, allThreeKindsOfLines_areRead) {
  for (const std::string prefix : {"", "left"}) {
    const ReadSrdf srdf = read(
        robotXml("<group name='arm'/><disable_collisions link1='a' link2='b' reason='Adjacent'/>"
                 "<enable_collisions link1='c' link2='a'/>"
                 "<disable_default_collisions link='b'/>"),
        prefix);
    const std::string front = prefix.empty() ? "" : prefix + "/";
    EXPECT_TRUE(srdf.errors.empty());
    EXPECT_TRUE(srdf.warnings.empty());
    ASSERT_EQ(srdf.pairs.disabled.size(), 1u);
    EXPECT_EQ(pairText(srdf, srdf.pairs.disabled[0]), front + "a " + front + "b Adjacent");
    ASSERT_EQ(srdf.pairs.enabled.size(), 1u);
    EXPECT_EQ(pairText(srdf, srdf.pairs.enabled[0]), front + "c " + front + "a ");
    ASSERT_EQ(srdf.pairs.disabled_by_default.size(), 1u);
    EXPECT_EQ(srdf.model.link(srdf.pairs.disabled_by_default[0]).name, front + "b");
  }
}

TEST(SrdfReader, nameOfAnotherRobot_isAWarningAndAUrdfIsNoSrdf) {
  const std::string line = "<disable_collisions link1='a' link2='c'/>";
  const ReadSrdf other = read("<robot name='other'>" + line + "</robot>");
  EXPECT_EQ(other.warnings,
            std::vector<std::string>{"test.srdf line 1: robot name 'other'; the URDF's is 'r'; it "
                                     "is read all the same"});
  EXPECT_EQ(other.pairs.disabled.size(), 1u);
  EXPECT_TRUE(read("<robot>" + line + "</robot>").warnings.empty());
  EXPECT_EQ(read(robotXml("<link name='a'/>")).errors,
            std::vector<std::string>{"test.srdf line 2: <link>, as in a URDF; accepted: an SRDF"});
}

TEST(SrdfReader, unknownLinks_areOneWarning) {
  const ReadSrdf srdf =
      read(robotXml("<disable_collisions link1='a' link2='x'/>"
                    "<disable_collisions link1='x' link2='y'/>"
                    "<disable_collisions link1='a' link2='c'/>"));
  EXPECT_EQ(srdf.pairs.disabled.size(), 1u);
  EXPECT_EQ(srdf.warnings,
            std::vector<std::string>{"test.srdf: unknown links: 'x' (line 2) and 'y' (line 2); the "
                                     "robot lacks them; lines that name them are ignored"});
}

// It can only lead to more pairs being checked, so a robot whose SRDF was published with names of
// another version starts.
TEST(SrdfReader, noneOfTheLinksKnown_isAWarning) {
  const ReadSrdf srdf = read(robotXml("\n<disable_collisions link1='x' link2='y'/>"));
  EXPECT_TRUE(srdf.errors.empty());
  EXPECT_EQ(srdf.warnings,
            std::vector<std::string>{"test.srdf: not one of its links is known, unknown links: 'x' "
                                     "(line 3) and 'y' (line 3); the robot lacks them; lines "
                                     "that name them are ignored"});
}

TEST(SrdfReader, strict_unknownNamesAreErrors) {
  const ReadSrdf srdf = read(robotXml("<disable_collisions link1='a' link2='x'/>\n"
                                      "<group name='g'><joint name='q'/></group>"),
                             "", true);
  EXPECT_TRUE(srdf.warnings.empty());
  EXPECT_EQ(srdf.errors,
            (std::vector<std::string>{"test.srdf: unknown links: 'x' (line 2); accepted: links of "
                                      "the URDF (strict)",
                                      "test.srdf: groups with unknown members: joint 'q' (line 3); "
                                      "accepted: names of the URDF and of groups (strict)"}));
}

TEST(SrdfReader, manyUnknownNames_areAFewAndHowManyMore) {
  std::string lines;
  for (int i = 0; i < 100'000; ++i) {
    lines += "<disable_default_collisions link='x" + std::to_string(i) + "'/>\n";
  }
  const ReadSrdf srdf = read(robotXml(lines));
  ASSERT_EQ(srdf.warnings.size(), 1U);
  EXPECT_NE(srdf.warnings[0].find("'x11' (line 13) and 99988 more"), std::string::npos)
      << srdf.warnings[0].substr(0, 400);
}

TEST(SrdfReader, sourceNotGiven_isThatOfTheUrdf) {
  RobotDescription description = test::describeText(robotXml("<link name='a'/>"));
  description.srdf_xml = "<robot>";
  SetupReport report;
  const RobotModel model = readRobots({description}, test::textLoader({}), report);
  readSrdf(description, RobotId{0}, model, report);
  ASSERT_EQ(report.errors.size(), 1U);
  EXPECT_EQ(report.errors[0].where.substr(0, 16), "test.urdf (SRDF)");
}

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

TEST(SrdfReader, srdfWithoutPairs_isFine) {
  const ReadSrdf srdf = read(robotXml("<group name='arm'/>"));
  EXPECT_TRUE(srdf.errors.empty());
  EXPECT_TRUE(srdf.warnings.empty());
}

TEST(SrdfReader, faults_areReportedWithTheirLines) {
  const ReadSrdf srdf =
      read(robotXml("<disable_collisions link1='a'/>\n"
                    "<disable_default_collisions/>\n"
                    "<disable_collisions link1='b' link2='b'/>"));
  EXPECT_EQ(srdf.errors,
            (std::vector<std::string>{
                "test.srdf line 2: <disable_collisions> without link2; accepted: "
                "link2=\"...\" that is not blank",
                "test.srdf line 3: <disable_default_collisions> without link; accepted: "
                "link=\"...\" that is not blank"}));
  EXPECT_EQ(srdf.warnings,
            std::vector<std::string>{"test.srdf line 4: <disable_collisions> of 'b' with itself; "
                                     "the line is ignored"});
}

TEST(SrdfReader, contradiction_isAWarning) {
  EXPECT_EQ(read(robotXml("<disable_collisions link1='a' link2='b'/>"
                          "<enable_collisions link1='b' link2='a'/>"))
                .warnings,
            std::vector<std::string>{"test.srdf: pairs that are both enabled and disabled: "
                                     "'b' - 'a'; these are checked"});
}

TEST(SrdfReader, badXml_isAnErrorAlsoWithoutTheRobot) {
  RobotDescription description = test::describeText("");
  description.srdf_xml = "<robot>\n<x></robot>";
  SetupReport report;
  readSrdf(description, RobotId{0}, RobotModel{}, report);
  ASSERT_EQ(report.errors.size(), 1u);
  EXPECT_EQ(report.errors[0].where, "test.urdf (SRDF) line 2");
}

}  // namespace
}  // namespace collision_monitor
