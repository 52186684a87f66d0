// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/model/pair_rules.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "support/robots/urdf_text.h"

namespace collision_monitor {
namespace {

using test::jointXml;
using test::readText;
using test::robotXml;

std::string solid(const std::string& name) { return test::linkXml(name, "<sphere radius='0.1'/>"); }

std::string hollow(const std::string& name) { return "<link name='" + name + "'/>"; }

std::string moving(const std::string& parent, const std::string& child) {
  return jointXml(parent + "_" + child, "continuous", parent, child);
}

std::string fixed(const std::string& parent, const std::string& child) {
  return jointXml(parent + "_" + child, "fixed", parent, child);
}

using Reasons = std::map<std::string, PairReason>;

/// Reasons by "a b" with the names in the order of the pair.
Reasons reasonsOf(const RobotModel& model, const std::vector<SrdfPairs>& srdfs = {},
                  const std::vector<LinkIdPair>& ignored = {}) {
  Reasons reasons;
  for (const LinkPair& pair : decideLinkPairs(model, srdfs, ignored)) {
    EXPECT_LT(pair.a, pair.b);
    reasons[model.link(pair.a).name + " " + model.link(pair.b).name] = pair.reason;
  }
  return reasons;
}

TEST(PairRules, chain_neighboursAreAdjacentOthersChecked) {
  const RobotModel model =
      readText(robotXml(solid("a") + solid("b") + solid("c") + moving("a", "b") + moving("b", "c")))
          .model;
  EXPECT_EQ(reasonsOf(model), (Reasons{{"a b", PairReason::adjacent},
                                       {"a c", PairReason::checked},
                                       {"b c", PairReason::adjacent}}));
}

TEST(PairRules, linkWithoutGeometry_isPassedThroughAndStandsInNoPair) {
  // a - (no geometry) - b: one joint of two axes.
  const RobotModel model =
      readText(robotXml(solid("a") + hollow("x") + solid("b") + solid("c") + moving("a", "x") +
                        moving("x", "b") + moving("b", "c")))
          .model;
  EXPECT_EQ(reasonsOf(model), (Reasons{{"a b", PairReason::adjacent},
                                       {"a c", PairReason::checked},
                                       {"b c", PairReason::adjacent}}));
}

TEST(PairRules, siblings_areChecked) {
  const RobotModel model = readText(robotXml(hollow("root") + solid("a") + solid("b") +
                                             moving("root", "a") + moving("root", "b")))
                               .model;
  EXPECT_EQ(reasonsOf(model), (Reasons{{"a b", PairReason::checked}}));
}

TEST(PairRules, fixedJointsOnly_areOneRigidGroup) {
  // hand and its two pads hang on the wrist; pads are a group by way of the hand.
  const RobotModel model = readText(robotXml(solid("wrist") + hollow("flange") + solid("pad_1") +
                                             solid("pad_2") + fixed("wrist", "flange") +
                                             fixed("flange", "pad_1") + fixed("flange", "pad_2")))
                               .model;
  EXPECT_EQ(reasonsOf(model), (Reasons{{"pad_1 pad_2", PairReason::same_rigid_group},
                                       {"wrist pad_1", PairReason::same_rigid_group},
                                       {"wrist pad_2", PairReason::same_rigid_group}}));
}

TEST(PairRules, jointLockedByItsLimits_isNoRigidGroup) {
  const RobotModel model =
      readText(robotXml(solid("a") + solid("b") + solid("c") + moving("a", "b") +
                        jointXml("j", "revolute", "b", "c", "<limit lower='0' upper='0'/>")))
          .model;
  EXPECT_EQ(reasonsOf(model).at("a c"), PairReason::checked);
}

/// a -moving- b -moving- c -fixed- d, all with geometry, with an SRDF.
struct WithSrdf {
  RobotModel model = readText(robotXml(solid("a") + solid("b") + solid("c") + solid("d") +
                                       moving("a", "b") + moving("b", "c") + fixed("c", "d")))
                         .model;
  SrdfPairs srdf;

  SrdfPairs::Entry pair(const std::string& a, const std::string& b) {
    return {model.findLink(a).value(), model.findLink(b).value(), ""};
  }
  Reasons reasons() { return reasonsOf(model, {srdf}); }
};

TEST(PairRules, disableLine_ignoresInEitherOrder) {
  WithSrdf robot;
  robot.srdf.disabled = {robot.pair("c", "a")};
  EXPECT_EQ(robot.reasons().at("a c"), PairReason::disabled_by_srdf);
  EXPECT_EQ(robot.reasons().at("a d"), PairReason::checked);
  EXPECT_EQ(robot.reasons().at("a b"), PairReason::adjacent);
}

TEST(PairRules, disableDefault_ignoresAllPairsOfTheLink) {
  WithSrdf robot;
  robot.srdf.disabled_by_default = {{robot.model.findLink("a").value(), 1}};
  EXPECT_EQ(robot.reasons().at("a b"), PairReason::disabled_by_srdf);
  EXPECT_EQ(robot.reasons().at("a c"), PairReason::disabled_by_srdf);
  EXPECT_EQ(robot.reasons().at("b d"), PairReason::checked);
}

TEST(PairRules, enableLine_winsOverAdjacencyDefaultAndDisableLine) {
  WithSrdf robot;
  robot.srdf.disabled_by_default = {{robot.model.findLink("a").value(), 1}};
  robot.srdf.disabled = {robot.pair("a", "d")};
  robot.srdf.enabled = {robot.pair("a", "b"), robot.pair("a", "c"), robot.pair("d", "a")};
  EXPECT_EQ(robot.reasons().at("a b"), PairReason::enabled_by_srdf);
  EXPECT_EQ(robot.reasons().at("a c"), PairReason::enabled_by_srdf);
  EXPECT_EQ(robot.reasons().at("a d"), PairReason::enabled_by_srdf);
}

TEST(PairRules, enableLine_neverWinsOverTheRigidGroup) {
  WithSrdf robot;
  robot.srdf.enabled = {robot.pair("c", "d")};
  EXPECT_EQ(robot.reasons().at("c d"), PairReason::same_rigid_group);
}

TEST(PairRules, linksOfDifferentRobots_areChecked) {
  RobotDescription left = test::describeText(robotXml(solid("a")));
  RobotDescription right = left;
  left.tf_prefix = "left";
  right.tf_prefix = "right";
  SetupReport report;
  const RobotModel model = readRobots({left, right}, test::textLoader({}), report);
  SrdfPairs srdf;
  srdf.disabled_by_default = {{LinkId{0}, 1}};
  EXPECT_EQ(reasonsOf(model, {srdf}), (Reasons{{"left/a right/a", PairReason::checked}}));
}

/// Links "cell/table" and "cell/wall", and twice an arm of a, b and c, "left" and "right".
RobotModel twoArmsInACell() {
  RobotDescription cell =
      test::describeText(robotXml(solid("table") + solid("wall") + fixed("table", "wall")));
  RobotDescription left = test::describeText(
      robotXml(solid("a") + solid("b") + solid("c") + moving("a", "b") + moving("b", "c")));
  RobotDescription right = left;
  cell.tf_prefix = "cell";
  left.tf_prefix = "left";
  right.tf_prefix = "right";
  SetupReport report;
  return readRobots({cell, left, right}, test::textLoader({}), report);
}

TEST(PairRules, namedPair_isIgnoredAmongRobotsAndWithinOne) {
  const RobotModel model = twoArmsInACell();
  SetupReport report;
  SrdfPairs srdf;
  srdf.robot = RobotId{1};
  srdf.enabled = {{*model.findLink("left/a"), *model.findLink("left/c"), ""}};
  const Reasons reasons = reasonsOf(
      model, {srdf},
      findNamedPairs({{"left/a", "cell/table"}, {"left/c", "left/a"}}, "pairs", model, report));
  EXPECT_TRUE(report.errors.empty());
  EXPECT_EQ(reasons.at("cell/table left/a"), PairReason::ignored_by_user);
  EXPECT_EQ(reasons.at("left/a left/c"), PairReason::ignored_by_user);
  EXPECT_EQ(reasons.at("cell/table left/b"), PairReason::checked);
  EXPECT_EQ(reasons.at("cell/wall left/a"), PairReason::checked);
  EXPECT_EQ(reasons.at("cell/table right/a"), PairReason::checked);
}

TEST(PairRules, namedPair_byPatternsAndNamesOfTheUrdf) {
  const RobotModel model = twoArmsInACell();
  SetupReport report;
  const Reasons reasons = reasonsOf(
      model, {}, findNamedPairs({{"cell/*", "a"}, {"*/?", "right/c"}}, "pairs", model, report));
  EXPECT_TRUE(report.errors.empty());
  for (const char* pair : {"cell/table left/a", "cell/wall left/a", "cell/table right/a",
                           "left/b right/c", "right/a right/c"}) {
    EXPECT_EQ(reasons.at(pair), PairReason::ignored_by_user) << pair;
  }
  EXPECT_EQ(reasons.at("left/c right/b"), PairReason::checked);
  EXPECT_EQ(reasons.at("cell/table right/c"), PairReason::checked);
}

TEST(PairRules, namedPairThatIsNone_isAnError) {
  const RobotModel model = twoArmsInACell();
  SetupReport report;
  findNamedPairs({{"left/a", "cell/tabel"}, {"left/a", "left/a"}, {"left/a", "left/*"}},
                 "/m/ignore_pairs", model, report);
  ASSERT_EQ(report.errors.size(), 2u);
  EXPECT_EQ(report.errors[0].where, "/m/ignore_pairs[0]");
  EXPECT_EQ(report.errors[0].found, "link 'cell/tabel', which matches none");
  EXPECT_EQ(report.errors[1].where, "/m/ignore_pairs[1]");
  EXPECT_EQ(report.errors[1].found, "'left/a' twice");
}

TEST(PairRules, pairs_areSortedAndComplete) {
  const RobotModel model = WithSrdf().model;
  const std::vector<LinkPair> pairs = decideLinkPairs(model, {});
  ASSERT_EQ(pairs.size(), 6u);
  for (std::size_t i = 1; i < pairs.size(); ++i) {
    EXPECT_LT(std::pair(pairs[i - 1].a, pairs[i - 1].b), std::pair(pairs[i].a, pairs[i].b));
  }
}

TEST(PairRules, reasonTexts_sayWhetherThePairIsChecked) {
  std::set<std::string> texts;
  for (int i = 0; i <= static_cast<int>(PairReason::two_objects); ++i) {
    const auto reason = static_cast<PairReason>(i);
    const std::string text = reasonText(reason);
    const char* const word = isChecked(reason)             ? "checked: "
                             : reason == PairReason::muted ? "muted: "
                                                           : "ignored: ";
    EXPECT_EQ(text.rfind(word, 0), 0u) << text;
    texts.insert(text);
  }
  EXPECT_EQ(texts.size(), 12u);
}

}  // namespace
}  // namespace collision_monitor
