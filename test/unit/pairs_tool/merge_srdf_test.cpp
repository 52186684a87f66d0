// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "merge_srdf.h"

#include <gtest/gtest.h>

#include "srdf_scene.h"

namespace collision_monitor::pairs_tool {
namespace {

const std::string kAdded = disable("a", "b", "Adjacent");
const std::string kAddedToo = disable("c", "d", "Never");

std::string inRobot(const std::string& content) {
  return "<robot name=\"r\">\n" + content + "</robot>\n";
}

TEST(MergeSrdf, whatIsMissing_isAddedBehindTheLastLine_andNothingElseChanges) {
  const std::string former =
      "<?xml version=\"1.0\" ?>\n<!-- by hand -->\n<robot name=\"r\">\n"
      "\t<group name='arm'>\n\t\t<chain base_link='a' tip_link='d' />\n\t</group>\n"
      "\t<disable_collisions link2='c'   link1='b' reason='User' /> <!-- why -->\n"
      "\t<passive_joint name='x'/>\n</robot>";  // no end of line
  const std::string why = "<!-- why -->\n";
  EXPECT_EQ(SrdfScene().merge(former).text,
            replaced(former, why, why + "\t" + kAdded + "\n\t" + kAddedToo + "\n"));
}

TEST(MergeSrdf, linesThatAreThere_stayAsTheyAre_whicheverWayRound) {
  const std::string former = inRobot(
      "<disable_collisions link1=\"b\" link2=\"a\" reason=\"mine\"></disable_collisions>\n"
      "<disable_collisions\n   link2='/d'\n   link1=' c '/>\n");
  const SrdfMerge merge = SrdfScene().merge(former);
  EXPECT_EQ(merge.text, former);
  EXPECT_EQ(merge.added, 0U);
  EXPECT_EQ(merge.kept, 2U);
  EXPECT_EQ(merge.left_out, 1U);
}

TEST(MergeSrdf, onlyWhatStatesSaid_isRefutedByStates) {
  const std::string kept =
      "  " + disable("a", "c", "Default") + "\n  " + disable("b", "d", "Adjacent") + "\n  " +
      disable("a", "d", "Never") + "\n  " + disable("b", "c", "Never") + "\n  " +
      disable("a", "gone", "Never") + "\n  " + kAdded + "\n  " + kAddedToo + "\n";
  const SrdfMerge merge = SrdfScene().merge(inRobot("  " + disable("a", "c", "Never") + "\n  " +
                                                    disable("d", "b", "Always") + "\n" + kept));
  EXPECT_EQ(merge.text, inRobot(kept));
  EXPECT_EQ(merge.kept, 7U);
  EXPECT_EQ(merge.left_out, 0U);  // it is in the file
  ASSERT_EQ(merge.taken_out.size(), 2U);
  EXPECT_EQ(merge.taken_out[0],
            "line 2, 'a' - 'c' (Never): they touch at elbow=0.5 and are apart in other states");
  EXPECT_EQ(merge.doubted, (std::vector<std::string>{"line 4, 'a' - 'c' (Default)",
                                                     "line 5, 'b' - 'd' (Adjacent)"}));
}

TEST(MergeSrdf, pairThatTheFileEnables_isNotDisabled) {
  const std::string former = inRobot(kAddedToo + "<enable_collisions link1='b' link2='a'/>\n");
  EXPECT_EQ(SrdfScene().merge(former).text, former);
}

TEST(MergeSrdf, twice_changesNothingMore) {
  const std::string once = SrdfScene().merge(inRobot("<group name='g'/>\n")).text;
  EXPECT_EQ(SrdfScene().merge(once).text, once);
}

TEST(MergeSrdf, namesOfUrdf_areEscaped) {
  SrdfScene scene;
  scene.lines.lines = {{"a & \"b\"", "<c>", "Never"}};
  const SrdfMerge merge = scene.merge(inRobot(""));
  EXPECT_NE(merge.text.find("link1=\"a &amp; &quot;b&quot;\" link2=\"&lt;c&gt;\""),
            std::string::npos)
      << merge.text;
  EXPECT_EQ(scene.merge(merge.text).added, 0U);
}

TEST(MergeSrdf, anEncodingThatNamesDoNotFit_isRefused) {
  const std::string latin = "<?xml version='1.0' encoding='ISO-8859-1'?>\n" +
                            inRobot("  <!-- caf\xE9 --><group name='\xE9'/>\n");
  SrdfScene scene;
  EXPECT_EQ(scene.merge(latin).text,
            replaced(latin, "\n</robot>", "\n  " + kAdded + "\n  " + kAddedToo + "\n</robot>"));
  scene.lines.lines.push_back({"h\xC3\xA9", "a", "Never"});
  EXPECT_THROW(scene.merge(latin), std::runtime_error);
  EXPECT_EQ(scene.merge(inRobot("")).added, 3U);
}

/// @return what is wrong, empty if it can be merged into.
std::string faultOf(const std::string& srdf, const std::string& robot = "r") {
  SetupReport report;
  checkMergeable("file.srdf", srdf, robot, "--write-srdf", report);
  EXPECT_LE(report.errors.size(), 1U);
  return report.errors.empty() ? "" : toString(report.errors.front());
}

TEST(MergeSrdf, whatIsNoSrdfOfTheRobot_isRefused) {
  EXPECT_EQ(faultOf(inRobot("")), "");
  EXPECT_EQ(faultOf("<robot name='other'/>", ""), "");
  const std::vector<std::pair<std::string, const char*>> cases{
      {"", "empty SRDF"},
      {"groups: []\n", "malformed or unfinished"},
      {"<robot name='r'>", "cannot be parsed"},
      {inRobot("<group>"), "closing tag"},
      {inRobot("<group name='a' name='b'/>"), "malformed attribute"},
      {inRobot("<group name='a & b'/>"), "line 2: not well-formed"},
      {"<srdf name='r'/>", "root element <srdf>"},
      {"<robot name='s'/>", "robot name 's'"},
      {"<robot/>", "robot name ''"},
      {inRobot("<link name='a'/>"), "as in a URDF"},
      {inRobot("<disable_collisions link1='${a}' link2='b'/>"), "xacro"},
      {"<!DOCTYPE robot [<!ENTITY e 'x'>]>" + inRobot(""), ""},
      {std::string("<r\0o", 4), "zero byte"},
      {std::string("<\0r\0o\0b\0", 8), "SRDF in UTF-16"}};
  for (const auto& [srdf, expected] : cases) {
    const std::string fault = faultOf(srdf);
    EXPECT_NE(fault, "") << srdf;
    EXPECT_NE(fault.find(expected), std::string::npos) << fault;
    EXPECT_NE(fault.find("file.srdf"), std::string::npos) << fault;
  }
}

TEST(MergeSrdf, robotName) {
  EXPECT_EQ(robotNameOf("<!-- late --><?xml version='1.0'?><robot name='r &amp; s'/>"), "r & s");
  EXPECT_EQ(robotNameOf("<robot/>"), "");
  EXPECT_EQ(robotNameOf("<robot"), "");
}

}  // namespace
}  // namespace collision_monitor::pairs_tool
