// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "urdf_fault.h"

namespace collision_monitor {
namespace {

using test::expectFaults;
using test::jointXml;
using test::linkXml;
using test::readText;
using test::ReadText;
using test::robotXml;

const std::string kOneRobot = "accepted: the XML of one URDF with the root element <robot>";
const std::string kShapes =
    "accepted: <box size>, <sphere radius>, <cylinder radius length>, <capsule radius length> or "
    "<mesh filename>";

TEST(UrdfFaults, notAUrdfAtAll) {
  expectFaults({
      {"empty", "", {"test.urdf: empty URDF; " + kOneRobot}},
      {"blank", " \n\t", {"test.urdf: empty URDF; " + kOneRobot}},
      {"text",
       "hello",
       {"test.urdf line 1: XML that cannot be parsed: malformed or unfinished XML; " + kOneRobot}},
      {"comment alone", "<!-- x -->", {"test.urdf: no element at all; " + kOneRobot}},
      {"sdf", "\n<sdf/>", {"test.urdf line 2: root element <sdf>; " + kOneRobot}},
      {"two roots",
       "<robot/>\n<robot/>",
       {"test.urdf line 2: a second root element <robot>; " + kOneRobot}},
      {"closing tag",
       "<robot>\n<link name='a'>\n</robot>",
       {"test.urdf line 2: XML that cannot be parsed: closing tag that does not match; " +
        kOneRobot}},
      {"attribute",
       "<robot>\n<link name=a/>\n</robot>",
       {"test.urdf line 2: XML that cannot be parsed: malformed attribute; " + kOneRobot}},
      {"zero byte",
       std::string("<robot>\0</robot>", 16),
       {"test.urdf: URDF with a zero byte; " + kOneRobot}},
      {"UTF-16",
       std::string("\xFF\xFE<\0r\0o\0b\0o\0t\0/\0>\0", 18),
       {"test.urdf: URDF in UTF-16; accepted: UTF-8; 'iconv -f UTF-16 -t UTF-8 FILE' turns it into "
        "that"}},
      {"UTF-32 without a mark",
       std::string("\0\0\0<\0\0\0r", 8),
       {"test.urdf: URDF in UTF-32; accepted: UTF-8; 'iconv -f UTF-32 -t UTF-8 FILE' turns it into "
        "that"}},
      {"no links", "<robot name='r'/>", {"test.urdf: no links; accepted: at least one <link>"}},
  });
}

TEST(UrdfFaults, xacroThatWasNotExpanded) {
  const std::string accepted =
      "; accepted: plain URDF: expand it first, for example with 'rosrun xacro xacro FILE'";
  expectFaults({
      {"element",
       robotXml("<xacro:include filename='x'/>"),
       {"test.urdf line 2: xacro that was not expanded, in <xacro:include>" + accepted}},
      {"expression",
       robotXml(linkXml("a", "\n<sphere radius='${r}'/>")),
       {"test.urdf line 3: xacro that was not expanded, in <sphere>" + accepted}},
      {"substitution",
       robotXml("<link name='$(arg name)'/>"),
       {"test.urdf line 2: xacro that was not expanded, in <link>" + accepted}},
  });
  // Extensions may say what they like.
  EXPECT_TRUE(
      readText(robotXml("<link name='a'/><gazebo><p v='$(arg x)'/></gazebo>")).errors().empty());
}

TEST(UrdfFaults, sizes) {
  const std::string at = "test.urdf line 2, link 'a', collision 1: ";
  const std::string above = "; accepted: one number greater than 0, in metres";
  const std::string box = "; accepted: three numbers that are 0 or greater, in metres";
  expectFaults({
      {"box",
       robotXml(linkXml("a", "<box size='0.1 -0.2 0.3'/>")),
       {at + "box size '0.1 -0.2 0.3'" + box}},
      {"word",
       robotXml(linkXml("a", "<box size='0.1 abc 0.3'/>")),
       {at + "box size '0.1 abc 0.3': 'abc' is not a number" + box}},
      {"count",
       robotXml(linkXml("a", "<box size='1 2'/>")),
       {at + "box size '1 2': 2 numbers" + box}},
      {"missing", robotXml(linkXml("a", "<box/>")), {at + "<box> without size" + box}},
      {"sphere",
       robotXml(linkXml("a", "<sphere radius='-1'/>")),
       {at + "sphere radius '-1'; accepted: one number that is 0 or greater, in metres"}},
      {"comma",
       robotXml(linkXml("a", "<cylinder radius='1,5' length='1'/>")),
       {at + "cylinder radius '1,5': '1,5' is not a number" + above}},
      {"both",
       robotXml(linkXml("a", "<cylinder radius='0' length='nan'/>")),
       {at + "cylinder radius '0'" + above,
        at + "cylinder length 'nan': 'nan' is not finite" + above}},
      {"capsule",
       robotXml(linkXml("a", "<capsule radius='0x1' length='-1'/>")),
       {at + "capsule radius '0x1': '0x1' is not a number" + above,
        at + "capsule length '-1'; accepted: one number that is 0 or greater, in metres"}},
  });
}

TEST(UrdfFaults, geometryAndOrigins) {
  const std::string at = "test.urdf line 2, link 'a', collision 1: ";
  expectFaults({
      {"unknown",
       robotXml(linkXml("a", "<cone radius='1'/>")),
       {at + "unknown geometry <cone>; " + kShapes}},
      {"unknown extension",
       robotXml(linkXml("a", "<drake:ellipsoid/>")),
       {at + "unknown geometry <drake:ellipsoid>; " + kShapes}},
      {"none", robotXml(linkXml("a", "")), {at + "<geometry> without a shape; " + kShapes}},
      {"two",
       robotXml(linkXml("a", "<sphere radius='1'/>\n<box size='1 1 1'/>")),
       {"test.urdf line 3, link 'a', collision 1: <geometry> with a second shape <box>; accepted: "
        "one shape; further ones in <collision> elements of their own"}},
      {"origin inside",
       robotXml(linkXml("a", "<box size='1 1 1'/>\n<origin xyz='0 0 1'/>")),
       {"test.urdf line 3, link 'a', collision 1: <origin> inside of <geometry>; accepted: "
        "<origin> "
        "beside <geometry>, inside of <collision>"}},
      {"no geometry",
       robotXml("<link name='a'><collision name='x'/></link>"),
       {"test.urdf line 2, link 'a', collision 'x': <collision> without <geometry>; accepted: one "
        "<geometry> with one shape"}},
      {"rpy",
       robotXml(linkXml("a", "<sphere radius='1'/>", "<origin rpy='0 0'/>")),
       {at + "origin rpy '0 0': 2 numbers; accepted: three finite numbers separated by spaces, in "
             "radians"}},
      {"xyz",
       robotXml(linkXml("a", "<sphere radius='1'/>", "<origin xyz='0 inf 0'/>")),
       {at + "origin xyz '0 inf 0': 'inf' is not finite; accepted: three finite numbers separated "
             "by spaces, in metres"}},
      {"quaternion",
       robotXml(linkXml("a", "<sphere radius='1'/>", "<origin quat_xyzw='0 0 0 1'/>")),
       {at + "origin with quat_xyzw in a URDF of version 1.0; accepted: rpy, or <robot "
             "version=\"1.1\"> and later"}},
  });
}

TEST(UrdfFaults, names) {
  expectFaults({
      {"no name",
       robotXml("<link/>"),
       {"test.urdf line 2: <link> without name; accepted: name=\"...\" that is not blank",
        "test.urdf: no links; accepted: at least one <link>"}},
      {"slash",
       robotXml("<link name='/'/><link name='b'/>"),
       {"test.urdf line 2: name '/'; accepted: a name, not slashes alone"}},
      {"two links",
       robotXml("<link name='a'/>\n<link name='a'/>"),
       {"test.urdf line 3: a second link 'a', the first is in line 2; accepted: a name of its own "
        "for every link"}},
      {"two joints",
       robotXml("<link name='a'/><link name='b'/><link name='c'/>\n" +
                jointXml("j", "fixed", "a", "b") + "\n" + jointXml("j", "fixed", "a", "c")),
       {"test.urdf line 4: a second joint 'j', the first is in line 3; accepted: a name of its own "
        "for every joint"}},
  });
}

TEST(UrdfFaults, trees) {
  const std::string links = "<link name='a'/><link name='b'/><link name='c'/>\n";
  expectFaults({
      {"several roots",
       robotXml(links + jointXml("j", "fixed", "a", "b")),
       {"test.urdf: 2 root links: 'a' and 'c'; accepted: one link that no joint has as child; join "
        "the others to it, by fixed joints if they do not move"}},
      {"no root",
       robotXml(links + jointXml("j", "fixed", "a", "b") + jointXml("k", "fixed", "b", "c") +
                jointXml("l", "fixed", "c", "a")),
       {"test.urdf: no root link: the joints form a loop; accepted: one link that no joint has as "
        "child"}},
      {"loop beside the root",
       robotXml(links + jointXml("j", "fixed", "b", "c") + jointXml("k", "fixed", "c", "b")),
       {"test.urdf: links that hang on a loop of joints: 'b' and 'c'; accepted: a tree: every link "
        "reached from the root 'a'"}},
      {"two parents",
       robotXml(links + jointXml("j", "fixed", "a", "b") + jointXml("k", "fixed", "a", "c") + "\n" +
                jointXml("l", "fixed", "c", "b")),
       {"test.urdf line 4, link 'b': a second parent by joint 'l', the first is by 'j' in line 3; "
        "accepted: one joint that has this link as its child"}},
      {"unknown link",
       robotXml(links + jointXml("j", "fixed", "a", "b") + jointXml("k", "fixed", "x", "y")),
       {"test.urdf line 3, joint 'k': unknown link 'x'; accepted: the name of a <link> of this "
        "robot",
        "test.urdf line 3, joint 'k': unknown link 'y'; accepted: the name of a <link> of this "
        "robot"}},
  });
}

/// Some licences stand before the declaration. XML has nothing before it; urdfdom takes it.
TEST(UrdfFaults, declarationBehindComments_isNoFault) {
  const std::string late = "<!-- licence -->\n<!-- of\nours -->\n<?xml version='1.0' ?>\n";
  const ReadText read = readText(late + robotXml(linkXml("a", "<sphere radius='1'/>")));
  EXPECT_TRUE(read.report.errors.empty()) << read.report.errors.front().found;
  EXPECT_TRUE(read.model.findLink("a"));
  const ReadText bad = readText(late + "<robot name='r'>\n<link/></robot>");
  ASSERT_FALSE(bad.report.errors.empty());
  EXPECT_EQ(bad.report.errors.front().where.substr(0, 16), "test.urdf line 6") << "lines stay";
  EXPECT_FALSE(readText("<robot name='r'>\n<?xml version='1.0' ?></robot>").report.errors.empty());
}

TEST(UrdfFaults, joints) {
  const std::string links = "<link name='a'/><link name='b'/>\n";
  const std::string at = "test.urdf line 3, joint 'j': ";
  const auto joint = [&](const std::string& type, const std::string& rest) {
    return robotXml(links + jointXml("j", type, "a", "b", rest));
  };
  expectFaults({
      {"type",
       joint("hinge", ""),
       {at + "joint type 'hinge'; accepted: fixed, revolute, continuous, prismatic, planar or "
             "floating"}},
      {"axis",
       joint("continuous", "<axis xyz='0 0 0'/>"),
       {at + "axis xyz '0 0 0'; accepted: three finite numbers, not all 0"}},
      {"axis numbers",
       joint("continuous", "<axis xyz='0 0'/>"),
       {at + "axis xyz '0 0': 2 numbers; accepted: three finite numbers, not all 0"}},
      {"limits",
       joint("revolute", "<limit lower='1' upper='-1'/>"),
       {at + "limit lower '1' above upper '-1'; accepted: lower <= upper"}},
      {"limit number",
       joint("revolute", "<limit lower='NaN' upper='1'/>"),
       {at + "limit lower 'NaN': 'NaN' is not finite; accepted: one finite number, in radians or "
             "metres"}},
      {"ends",
       robotXml(links + "<joint name='j' type='fixed'><parent link='a'/></joint>"),
       {at + "<joint> without <child>; accepted: <child link=\"...\"/>"}},
      {"mimic of itself",
       joint("continuous", "<mimic joint='j'/>"),
       {at + "mimic that leads in a circle; accepted: mimic of a joint that has its own position"}},
      {"mimic on planar",
       joint("planar", "<mimic joint='j'/>"),
       {at +
        "mimic on a joint with several variables; accepted: mimic on a revolute, continuous or "
        "prismatic joint"}},
  });
}

TEST(UrdfFaults, allFaultsOfAllRobotsAreReportedAtOnce) {
  const std::string bad =
      robotXml(linkXml("a", "<sphere radius='x'/>") + "\n" + linkXml("b", "<cone/>") + "\n" +
               jointXml("j", "hinge", "a", "z"));
  RobotDescription first = test::describeText(bad);
  RobotDescription second = test::describeText("<robot");
  first.source = "first.urdf";
  second.source = "second.urdf";
  SetupReport report;
  readRobots({first, second}, test::textLoader({}), report);
  ASSERT_EQ(report.errors.size(), 5u);
  EXPECT_EQ(report.errors[0].where, "first.urdf line 2, link 'a', collision 1");
  EXPECT_EQ(report.errors[1].where, "first.urdf line 3, link 'b', collision 1");
  EXPECT_EQ(report.errors[2].where, "first.urdf line 4, joint 'j'");
  EXPECT_EQ(report.errors[3].found, "unknown link 'z'");
  EXPECT_EQ(report.errors[4].where, "second.urdf line 1");
}

}  // namespace
}  // namespace collision_monitor
