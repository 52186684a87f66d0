// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/model/srdf_reader.h"

#include <gtest/gtest.h>

#include "support/robots/urdf_text.h"

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
    EXPECT_EQ(srdf.model.link(srdf.pairs.disabled_by_default[0].link).name, front + "b");
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

// Names of which no pair depends are told all the same: somebody meant something by them.
TEST(SrdfReader, unknownNamesOfOtherElements_areToldAsThose) {
  const std::string known = robotXml(
      "<virtual_joint name='v' parent_frame='w' child_link='/a'/><group name='g'/>"
      "<passive_joint name='v'/><passive_joint name='k'/><end_effector name='e' parent_link='c' "
      "group='g' parent_group='g'/><group_state name='s' group='g'><joint name='j' value='0'/>"
      "</group_state><link_sphere_approximation link='b'/><rotor_params name='x'/>");
  EXPECT_TRUE(read(known, "", true).errors.empty());
  const std::string lines =
      "<virtual_joint name='v' parent_frame='w' child_link='p'/>"
      "<passive_joint name='q'/><end_effector name='e' parent_link='r' group='s' "
      "parent_group='t'/><group_state name='s' group='u'><joint name='v'/><joint name='w'/>"
      "</group_state><link_sphere_approximation link='x'/>";
  const std::string found =
      "test.srdf: other elements with unknown names: link 'p' (line 2), joint 'q' (line 2), link "
      "'r' (line 2), group 's' (line 2), group 't' (line 2), group 'u' (line 2), joint 'w' (line "
      "2) and link 'x' (line 2); ";
  EXPECT_EQ(
      read(robotXml(lines)).warnings,
      std::vector<std::string>{found + "the robot lacks them; no pair depends on these elements"});
  EXPECT_EQ(read(robotXml(lines), "", true).errors,
            std::vector<std::string>{found + "accepted: names of the URDF and of groups (strict)"});
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

TEST(SrdfReader, srdfWithoutPairs_isFine) {
  const ReadSrdf srdf = read(robotXml("<group name='arm'/>"));
  EXPECT_TRUE(srdf.errors.empty());
  EXPECT_TRUE(srdf.warnings.empty());
}

TEST(SrdfReader, faults_areReportedWithTheirLines) {
  const ReadSrdf srdf =
      read(robotXml("<enable_collisions link1='a'/>\n\n"
                    "<disable_collisions link1='b' link2='b'/>"));
  EXPECT_EQ(srdf.errors, std::vector<std::string>{
                             "test.srdf line 2: <enable_collisions> without link2; accepted: "
                             "link2=\"...\" that is not blank"});
  EXPECT_EQ(srdf.warnings,
            std::vector<std::string>{"test.srdf line 4: <disable_collisions> of 'b' with itself; "
                                     "the line is ignored"});
}

// As with unknown names: more pairs are checked, never fewer.
TEST(SrdfReader, linesThatDisableNothing_areOneWarning) {
  const std::string lines = robotXml(
      "<disable_collisions link1='a'/>\n<disable_default_collisions/>\n"
      "<disable_collisions link1=' / ' link2='b'/><disable_collisions link1='a' link2='c'/>");
  const std::string found =
      "test.srdf: lines that name no link: <disable_collisions> without link2 (line 2), "
      "<disable_default_collisions> without link (line 3) and <disable_collisions> without link1 "
      "(line 4); ";
  const ReadSrdf srdf = read(lines);
  EXPECT_TRUE(srdf.errors.empty());
  EXPECT_EQ(srdf.warnings, std::vector<std::string>{found + "these lines are ignored"});
  EXPECT_EQ(srdf.pairs.disabled.size(), 1U);
  EXPECT_EQ(read(lines, "", true).errors,
            std::vector<std::string>{found + "accepted: names of links (strict)"});
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

TEST(SrdfReader, spheres_areThoseOfRadiusAboveZero) {
  const ReadSrdf srdf =
      read(robotXml("<link_sphere_approximation link='b'><sphere center='1 2 3' radius='0.5'/>"
                    "<sphere center='0 0 0' radius='0'/></link_sphere_approximation>\n"
                    "<link_sphere_approximation link='c'><sphere center='0 0 0' radius='0.0'/>"
                    "</link_sphere_approximation>"));
  EXPECT_TRUE(srdf.errors.empty());
  EXPECT_TRUE(srdf.warnings.empty());
  ASSERT_EQ(srdf.pairs.spheres.size(), 1u);
  EXPECT_EQ(srdf.model.link(srdf.pairs.spheres[0].link).name, "b");
  EXPECT_EQ(srdf.pairs.spheres[0].line, 2);
  ASSERT_EQ(srdf.pairs.spheres[0].spheres.size(), 1u);
  const PosedShape& sphere = srdf.pairs.spheres[0].spheres[0];
  EXPECT_EQ(std::get<Sphere>(sphere.shape).radius, 0.5);
  EXPECT_EQ(sphere.geometry_from_body.translation, Eigen::Vector3d(1, 2, 3));
}

TEST(SrdfReader, faultySpheres_areAWarningAndNotUsed) {
  for (const char* sphere :
       {"<sphere center='1 2' radius='0.5'/>", "<sphere center='1 2 3'/>",
        "<sphere center='1 2 nan' radius='0.5'/>", "<sphere center='1 2 3' radius='-0.5'/>"}) {
    const ReadSrdf srdf = read(robotXml("<link_sphere_approximation link='b'>" +
                                        std::string(sphere) + "</link_sphere_approximation>"));
    EXPECT_TRUE(srdf.errors.empty());
    EXPECT_EQ(srdf.warnings.size(), 1u) << sphere;
    EXPECT_TRUE(srdf.pairs.spheres.empty());
  }
}

TEST(SrdfReader, lines_keepTheirNumbers) {
  const ReadSrdf srdf = read(robotXml("\n<disable_collisions link1='a' link2='c'/>"));
  EXPECT_EQ(srdf.pairs.disabled.at(0).line, 3);
  EXPECT_EQ(srdf.pairs.source, "test.srdf");
}

}  // namespace
}  // namespace collision_monitor
