// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "check_srdf.h"

#include <gtest/gtest.h>

#include "support/robots/urdf_text.h"

namespace collision_monitor::pairs_tool {
namespace {

/// Four links in a star: base with three arms, each on a joint of its own.
struct StarScene {
  RobotModel model;
  std::vector<PairFound> pairs;

  StarScene() {
    const std::string ball = "<sphere radius='0.1'/>";
    std::string xml = test::linkXml("base", ball);
    for (const char* name : {"a", "b", "c"}) {
      xml += test::linkXml(name, ball) +
             test::jointXml(name + std::string("_joint"), "continuous", "base", name);
    }
    model = test::readText(test::robotXml(xml)).model;
  }
  void add(const std::string& a, const std::string& b, PairFinding finding, bool is_proven) {
    PairFound pair{*model.findLink(a), *model.findLink(b), finding, is_proven};
    pair.joints = {*model.findJoint(b + "_joint")};
    pair.touching = {0.0, 0.5, -0.25};
    pairs.push_back(pair);
  }
  SrdfCheck check(const std::string& lines, std::size_t errors = 0) const {
    RobotDescription description;
    description.srdf_xml = "<robot name='r'>\n" + lines + "</robot>\n";
    SetupReport report;
    SrdfCheck found = checkSrdf(description, model, pairs, report);
    EXPECT_EQ(report.errors.size(), errors);
    return found;
  }
};

const char* const kDisableBToC = "<disable_collisions link1='c' link2='b' reason='Never'/>\n";

TEST(CheckSrdf, disabledPairThatTouches_isToldWithLineAndState) {
  StarScene scene;
  scene.add("b", "c", PairFinding::sometimes, false);
  const SrdfCheck check = scene.check(kDisableBToC);
  EXPECT_EQ(check.touching,
            std::vector<std::string>{"'b' - 'c' (line 2, Never) touch at c_joint=-0.25"});
  EXPECT_TRUE(check.unclear.empty());
  EXPECT_TRUE(check.needless.empty());
  EXPECT_NE(textOf(check).find("1 pairs are disabled although they touch:\n  'b' - 'c'"),
            std::string::npos);
}

TEST(CheckSrdf, disabledPairs_thatTouchAlwaysOrNever_areRight) {
  StarScene scene;
  for (const bool is_proven : {false, true}) {
    scene.pairs.clear();
    scene.add("b", "c", PairFinding::always, is_proven);
    scene.add("a", "b", PairFinding::never, is_proven);
    const SrdfCheck check = scene.check(
        std::string(kDisableBToC) + "<disable_collisions link1='a' link2='b' reason='Never'/>\n");
    EXPECT_EQ(textOf(check), "the SRDF disables no pair that touches, and checks none in vain\n");
  }
}

TEST(CheckSrdf, checkedPairs_areNeedlessOnlyIfProven) {
  StarScene scene;
  scene.add("a", "b", PairFinding::never, true);
  scene.add("a", "c", PairFinding::never, false);
  scene.add("b", "c", PairFinding::always, true);
  EXPECT_EQ(scene.check("").needless,
            (std::vector<std::string>{"'a' - 'b' never touch", "'b' - 'c' always touch"}));
}

TEST(CheckSrdf, whatEncloses_isToldApart_andEnabledPairsAreChecked) {
  StarScene scene;
  scene.add("b", "c", PairFinding::unclear, false);
  const SrdfCheck check = scene.check(kDisableBToC);
  EXPECT_TRUE(check.touching.empty());
  EXPECT_EQ(check.unclear.size(), 1U);
  const SrdfCheck enabled =
      scene.check(std::string(kDisableBToC) + "<enable_collisions link1='b' link2='c'/>\n");
  EXPECT_TRUE(enabled.unclear.empty());
}

TEST(CheckSrdf, defaultsOfALink_disableItsPairs) {
  StarScene scene;
  scene.add("b", "c", PairFinding::sometimes, false);
  EXPECT_EQ(scene.check("<disable_default_collisions link='b'/>\n").touching,
            std::vector<std::string>{"'b' - 'c' touch at c_joint=-0.25"});
}

TEST(CheckSrdf, faultsOfTheFile_areReported) {
  StarScene scene;
  scene.add("b", "c", PairFinding::sometimes, false);
  EXPECT_TRUE(scene.check("<disable_collisions link1='b'\n", 1).touching.empty());
}

}  // namespace
}  // namespace collision_monitor::pairs_tool
