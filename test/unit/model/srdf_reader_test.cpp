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
ReadSrdf read(const std::string& srdf_xml, const std::string& prefix = "") {
  RobotDescription description = test::describeText(
      robotXml("<link name='a'/><link name='b'/><link name='c'/>" +
               jointXml("j", "continuous", "a", "b") + jointXml("k", "continuous", "b", "c")));
  description.srdf_xml = srdf_xml;
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

TEST(SrdfReader, unknownLinks_areOneWarning) {
  const ReadSrdf srdf =
      read(robotXml("<disable_collisions link1='a' link2='x'/>"
                    "<disable_collisions link1='x' link2='y'/>"
                    "<disable_collisions link1='a' link2='c'/>"));
  EXPECT_EQ(srdf.pairs.disabled.size(), 1u);
  EXPECT_EQ(srdf.warnings, std::vector<std::string>{
                               "test.urdf (SRDF): unknown links: 'x' and 'y'; accepted: links "
                               "of the URDF; lines that name others are ignored"});
}

TEST(SrdfReader, srdfOfAnotherRobot_isAnError) {
  EXPECT_EQ(read(robotXml("<disable_collisions link1='x' link2='y'/>")).errors,
            std::vector<std::string>{"test.urdf (SRDF): unknown links: 'x' and 'y'; accepted: the "
                                     "SRDF of this robot; not one of its links is named"});
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
                "test.urdf (SRDF) line 2: <disable_collisions> without link2; accepted: "
                "link2=\"...\" that is not blank",
                "test.urdf (SRDF) line 3: <disable_default_collisions> without link; accepted: "
                "link=\"...\" that is not blank"}));
  EXPECT_EQ(srdf.warnings,
            std::vector<std::string>{"test.urdf (SRDF) line 4: <disable_collisions> of 'b' with "
                                     "itself; accepted: two different links; the line is ignored"});
}

TEST(SrdfReader, contradiction_isAWarning) {
  EXPECT_EQ(
      read(robotXml("<disable_collisions link1='a' link2='b'/>"
                    "<enable_collisions link1='b' link2='a'/>"))
          .warnings,
      std::vector<std::string>{"test.urdf (SRDF): pairs that are both enabled and disabled: "
                               "'b' - 'a'; accepted: one line for a pair; these are checked"});
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
