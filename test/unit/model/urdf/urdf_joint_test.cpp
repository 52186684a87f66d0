// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "geometry/constants.h"
#include "support/robots/urdf_text.h"

namespace collision_monitor {
namespace {

using test::jointXml;
using test::readText;
using test::ReadText;
using test::robotXml;

const std::string kLinks = "<link name='a'/><link name='b'/><link name='c'/><link name='d'/>\n";
const std::string kFixedC = jointXml("jc", "fixed", "a", "c");
const std::string kFixedD = jointXml("jd", "fixed", "a", "d");

/// One joint "j" from a to b, of the given type and inner elements.
ReadText readJoint(const std::string& type, const std::string& rest) {
  return readText(robotXml(kLinks + jointXml("j", type, "a", "b", rest) + kFixedC + kFixedD));
}

Joint jointOf(const ReadText& read, const std::string& name = "j") {
  EXPECT_EQ(read.errors(), std::vector<std::string>());
  return read.model.joint(read.model.findJoint(name).value());
}

TEST(UrdfJoint, types_haveTheirVariables) {
  const std::pair<const char*, std::size_t> expected[] = {{"fixed", 0},      {"revolute", 1},
                                                          {"continuous", 1}, {"prismatic", 1},
                                                          {"planar", 3},     {"floating", 7}};
  for (const auto& [type, count] : expected) {
    EXPECT_EQ(readJoint(type, "<limit lower='-1' upper='1'/>").model.variable_count, count) << type;
  }
}

TEST(UrdfJoint, secondLimit_isAWarning) {
  const ReadText read =
      readJoint("revolute", "<limit lower='-1' upper='1'/><limit lower='-2' upper='2'/>");
  EXPECT_EQ(jointOf(read).upper, 1.0);
  EXPECT_EQ(read.warnings(),
            std::vector<std::string>{
                "test.urdf: several <limit> of one joint: joint 'j'; the first counts"});
}

TEST(UrdfJoint, axis_isNormalised) {
  EXPECT_TRUE(jointOf(readJoint("continuous", "<axis xyz='0 3 4'/>"))
                  .axis.isApprox(Eigen::Vector3d(0.0, 0.6, 0.8), 1e-15));
}

TEST(UrdfJoint, axisInTinyNumbers_isNormalised) {
  EXPECT_TRUE(jointOf(readJoint("continuous", "<axis xyz='0 0 1e-300'/>"))
                  .axis.isApprox(Eigen::Vector3d::UnitZ(), 1e-15));
}

TEST(UrdfJoint, axisMissing_isX) {
  EXPECT_EQ(jointOf(readJoint("continuous", "")).axis, Eigen::Vector3d::UnitX());
}

TEST(UrdfJoint, axisOfZerosOnFixedJoint_isIgnored) {
  EXPECT_EQ(jointOf(readJoint("fixed", "<axis xyz='0 0 0'/>")).type, JointType::fixed);
}

TEST(UrdfJoint, limits_areRead) {
  const Joint joint =
      jointOf(readJoint("revolute", "<limit lower='-1.5' upper='2' velocity='3' effort='9'/>"));
  EXPECT_EQ(joint.lower, -1.5);
  EXPECT_EQ(joint.upper, 2.0);
  EXPECT_EQ(joint.max_velocity, 3.0);
}

TEST(UrdfJoint, limitsOfContinuousJoint_areNone) {
  const Joint joint =
      jointOf(readJoint("continuous", "<limit lower='-1' upper='1' velocity='3'/>"));
  EXPECT_EQ(joint.lower, -kInfinity);
  EXPECT_EQ(joint.upper, kInfinity);
  EXPECT_EQ(joint.max_velocity, 3.0);
}

/// Exporters write "unlimited" so, of wheels and rotors above all.
TEST(UrdfJoint, limitsBeyondSense_areNoneAndAWarning) {
  const ReadText read = readJoint("revolute", "<limit lower='-1e16' upper='1e+16' velocity='2'/>");
  EXPECT_EQ(jointOf(read).lower, -kInfinity);
  EXPECT_EQ(jointOf(read).upper, kInfinity);
  EXPECT_EQ(read.warnings().back(),
            "test.urdf: limits beyond 1e9: joint 'j'; they are taken as unlimited");
  const Joint one_sided = jointOf(readJoint("prismatic", "<limit lower='1' upper='1e10'/>"));
  EXPECT_EQ(one_sided.lower, 1.0);
  EXPECT_EQ(one_sided.upper, kInfinity);
  EXPECT_EQ(jointOf(readJoint("prismatic", "<limit lower='-1e9' upper='1e9'/>")).upper, 1e9);
}

TEST(UrdfJoint, limitMissing_isUnlimitedAndAWarning) {
  for (const char* type : {"revolute", "prismatic"}) {
    const ReadText read = readJoint(type, "");
    EXPECT_EQ(jointOf(read).lower, -kInfinity);
    EXPECT_EQ(jointOf(read).upper, kInfinity);
    EXPECT_EQ(read.warnings().back(),
              "test.urdf: joints without <limit>: joint 'j'; they are taken as unlimited");
  }
}

TEST(UrdfJoint, limitWithoutRange_isLockedAsUrdfSaysAndAWarning) {
  const ReadText read = readJoint("revolute", "<limit effort='1' velocity='1'/>");
  EXPECT_EQ(jointOf(read).lower, 0.0);
  EXPECT_EQ(jointOf(read).upper, 0.0);
  EXPECT_EQ(read.warnings().back(),
            "test.urdf: <limit> without lower and upper: joint 'j'; both are 0 then, as the URDF "
            "format has it, and the joint is locked");
}

TEST(UrdfJoint, velocityLimitOfZero_isUnlimitedAndAWarning) {
  const ReadText read = readJoint("revolute", "<limit lower='0' upper='1' velocity='0'/>");
  EXPECT_EQ(jointOf(read).max_velocity, kInfinity);
  EXPECT_EQ(read.report.warnings.back().found, "velocity limits of 0 or less: joint 'j'");
}

TEST(UrdfJoint, mimic_sharesTheVariableOfItsSource) {
  const ReadText read = readText(robotXml(
      kLinks +
      jointXml("jb", "revolute", "a", "b",
               "<limit lower='0' upper='1'/><mimic joint='jc' multiplier='-2' offset='0.5'/>") +
      jointXml("jc", "continuous", "a", "c") + kFixedD));
  const Joint follower = jointOf(read, "jb");
  ASSERT_TRUE(follower.mimic);
  EXPECT_EQ(read.model.joint(follower.mimic->source).name, "jc");
  EXPECT_EQ(follower.mimic->multiplier, -2.0);
  EXPECT_EQ(follower.mimic->offset, 0.5);
  EXPECT_EQ(follower.first_variable, jointOf(read, "jc").first_variable);
  EXPECT_EQ(read.model.variable_count, 1u);
}

TEST(UrdfJoint, mimicOfMimic_followsTheEndOfTheChain) {
  // b = 2 c + 1 and c = 3 d - 1, so b = 6 d - 1.
  const ReadText read = readText(robotXml(
      kLinks +
      jointXml("jb", "continuous", "a", "b", "<mimic joint='jc' multiplier='2' offset='1'/>") +
      jointXml("jc", "continuous", "a", "c", "<mimic joint='jd' multiplier='3' offset='-1'/>") +
      jointXml("jd", "continuous", "a", "d")));
  const Joint joint = jointOf(read, "jb");
  ASSERT_TRUE(joint.mimic);
  EXPECT_EQ(read.model.joint(joint.mimic->source).name, "jd");
  EXPECT_EQ(joint.mimic->multiplier, 6.0);
  EXPECT_EQ(joint.mimic->offset, -1.0);
}

TEST(UrdfJoint, mimicOnFixedJoint_isAWarning) {
  const ReadText read = readJoint("fixed", "<mimic joint='jc'/>");
  EXPECT_FALSE(jointOf(read).mimic);
  EXPECT_EQ(read.report.warnings.back().found, "<mimic> on a fixed joint: joint 'j'");
}

TEST(UrdfJoint, mimicOfFixedJoint_movesByItselfAndIsAWarning) {
  const ReadText read = readJoint("continuous", "<mimic joint='jc'/>");
  EXPECT_FALSE(jointOf(read).mimic);
  EXPECT_EQ(read.model.variable_count, 1u);
  EXPECT_EQ(read.report.warnings.back().found, "<mimic> of a fixed joint: joint 'j'");
}

/// robot_state_publisher and MoveIt take such a robot, too: a gripper often follows a joint that
/// another description has. tf or joint_states say where the joint is, or it is unknown.
TEST(UrdfJoint, mimicOfUnknownJoint_movesByItselfAndIsAWarning) {
  const ReadText read =
      readJoint("continuous", "<mimic joint='elsewhere' multiplier='-1' offset='0.5'/>");
  ASSERT_TRUE(read.report.errors.empty());
  EXPECT_FALSE(jointOf(read).mimic);
  EXPECT_EQ(read.model.variable_count, 1u);
  EXPECT_EQ(
      read.warnings().back(),
      "test.urdf: <mimic> of a joint that the robot lacks: joint 'j' of 'elsewhere'; they are "
      "taken to move by themselves");
}

}  // namespace
}  // namespace collision_monitor
