// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report.h"

#include <gtest/gtest.h>

namespace collision_monitor::pairs_tool {
namespace {

/// Three links, two joints; one pair of each kind.
struct Scene {
  RobotModel model;
  std::vector<PairFound> pairs;

  Scene() {
    model.robots.push_back({"two & more", "", LinkId{0}, 0, 3, 0, 2});
    for (const char* name : {"base", "arm", "hand"}) {
      model.links.emplace_back().name = name;
    }
    for (std::size_t i = 0; i < 2; ++i) {
      Joint& joint = model.joints.emplace_back();
      joint.name = i == 0 ? "shoulder" : "wrist";
      joint.first_variable = i;
    }
    model.variable_count = 2;
  }
  PairFound& add(std::uint32_t a, std::uint32_t b, PairFinding finding, bool is_proven = false) {
    PairFound pair{LinkId{a}, LinkId{b}, finding, is_proven};
    pair.nearest = 0.0345;
    pair.joints = {JointId{1}};
    pair.touching = {0.5, -1.25};
    return pairs.emplace_back(pair);
  }
  std::string table() const { return tableOf(model, pairs, 100); }
};

TEST(Report, tableSaysWhy) {
  Scene scene;
  scene.add(0, 1, PairFinding::adjacent);
  scene.add(0, 2, PairFinding::sometimes);
  scene.add(1, 2, PairFinding::never);
  EXPECT_EQ(
      scene.table(),
      "link  link  touch      because\n"
      "base  arm   adjacent   the links meet at a joint\n"
      "base  hand  sometimes  at wrist=-1.25\n"
      "arm   hand  never      apart in all 100 states, shapes by 34.5 mm\n"
      "3 pairs, 1 adjacent, 0 always (0 proven), 1 sometimes, 0 perhaps, 1 never (0 proven)\n");
}

TEST(Report, whatIsProvenSaysSo) {
  Scene scene;
  scene.add(0, 1, PairFinding::never, true);
  EXPECT_NE(scene.table().find("never  proven\n"), std::string::npos);
  scene.pairs[0].joints.clear();
  EXPECT_NE(scene.table().find("never  proven: fixed apart\n"), std::string::npos);
  scene.pairs[0].finding = PairFinding::always;
  EXPECT_NE(scene.table().find("always  proven: fixed to each other\n"), std::string::npos);
  scene.pairs[0].joints = {JointId{1}};
  EXPECT_NE(scene.table().find("always  proven\n"), std::string::npos);
  scene.pairs[0].is_proven = false;
  EXPECT_NE(scene.table().find("always  touch in all 100 states\n"), std::string::npos);
}

TEST(Report, shapesThatOverlappedOfGeometriesThatDidNot_areNotCalledApart) {
  Scene scene;
  scene.add(0, 1, PairFinding::never).nearest = -0.0005;
  EXPECT_NE(
      scene.table().find("never  apart in all 100 states, though shapes overlapped by 0.5 mm\n"),
      std::string::npos);
}

/// "arm-hand Never", each.
std::vector<std::string> linesOf(const Scene& scene, bool trusts_samples, std::size_t left_out) {
  const PairLines found = pairs_tool::linesOf(scene.model, scene.pairs, trusts_samples);
  EXPECT_EQ(found.left_out.size(), left_out);
  std::vector<std::string> texts;
  for (const PairLine& line : found.lines) {
    texts.push_back(line.link1 + "-" + line.link2 + " " + line.reason);
  }
  return texts;
}

TEST(Report, lines_neverAndAlwaysOnlyIfProven_orSamplesAreTrusted) {
  Scene scene;
  scene.add(0, 1, PairFinding::adjacent);
  scene.add(0, 2, PairFinding::never, true);
  scene.add(1, 2, PairFinding::never);
  scene.add(0, 1, PairFinding::always, true);
  scene.add(0, 2, PairFinding::always);
  EXPECT_EQ(linesOf(scene, false, 2),
            (std::vector<std::string>{"base-arm Adjacent", "base-hand Never", "base-arm Always"}));
  EXPECT_EQ(linesOf(scene, true, 0),
            (std::vector<std::string>{"base-arm Adjacent", "base-hand Never", "arm-hand Never",
                                      "base-arm Always", "base-hand Always"}));
}

TEST(Report, lines_notOfWhatMayTouchAndMayNot) {
  Scene scene;
  scene.add(0, 1, PairFinding::sometimes);
  scene.add(0, 2, PairFinding::unclear);
  EXPECT_TRUE(linesOf(scene, true, 0).empty());
}

TEST(Report, ignoredPairsYaml_quotesNames) {
  EXPECT_EQ(pairs_tool::ignoredPairsYaml({{"base", "left/arm", "Never"}, {"a\\b", "\"", "Always"}}),
            "# Pairs that need no checking, found by the program pairs, for the monitor's "
            "parameters.\n"
            "ignore_pairs:\n"
            "  - [\"base\", \"left/arm\"]  # Never\n"
            "  - [\"a\\\\b\", \"\\\"\"]  # Always\n");
  EXPECT_NE(pairs_tool::ignoredPairsYaml({}).find("ignore_pairs: []\n"), std::string::npos);
}

TEST(Report, newSrdf) {
  EXPECT_EQ(pairs_tool::newSrdf("two & more", {{"base", "arm", "Adjacent"}}),
            "<?xml version=\"1.0\"?>\n"
            "<robot name=\"two &amp; more\">\n"
            "    <disable_collisions link1=\"base\" link2=\"arm\" reason=\"Adjacent\"/>\n"
            "</robot>\n");
}

}  // namespace
}  // namespace collision_monitor::pairs_tool
