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
  scene.pairs[0].is_proven = false;
  EXPECT_NE(scene.table().find("always  touch in all 100 states\n"), std::string::npos);
}

TEST(Report, srdf_leavesOutWhatIsNotProven_unlessSamplesAreTrusted) {
  Scene scene;
  scene.add(0, 1, PairFinding::adjacent);
  scene.add(0, 2, PairFinding::never, true);
  scene.add(1, 2, PairFinding::never);
  const PairSrdf careful = writeSrdf(scene.model, scene.pairs, false);
  EXPECT_EQ(careful.left_out, 1U);
  EXPECT_EQ(careful.text,
            "<?xml version=\"1.0\"?>\n"
            "<robot name=\"two &amp; more\">\n"
            "    <disable_collisions link1=\"base\" link2=\"arm\" reason=\"Adjacent\"/>\n"
            "    <disable_collisions link1=\"base\" link2=\"hand\" reason=\"Never\"/>\n"
            "</robot>\n");
  const PairSrdf trusting = writeSrdf(scene.model, scene.pairs, true);
  EXPECT_EQ(trusting.left_out, 0U);
  EXPECT_NE(trusting.text.find("link1=\"arm\" link2=\"hand\" reason=\"Never\""), std::string::npos);
}

TEST(Report, srdf_keepsWhatMayTouch) {
  Scene scene;
  scene.add(0, 1, PairFinding::sometimes);
  scene.add(0, 2, PairFinding::unclear);
  scene.add(1, 2, PairFinding::always);
  const std::string text = writeSrdf(scene.model, scene.pairs, true).text;
  EXPECT_EQ(text.find("base"), std::string::npos);
  EXPECT_NE(text.find("link1=\"arm\" link2=\"hand\" reason=\"Always\""), std::string::npos);
}

}  // namespace
}  // namespace collision_monitor::pairs_tool
