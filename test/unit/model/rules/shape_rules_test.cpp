// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/model/shape_rules.h"

#include <gtest/gtest.h>

#include "support/robots/rules_text.h"

namespace collision_monitor {
namespace {

using test::readFields;
using test::readRules;
using test::ReadRules;
using Texts = std::vector<std::string>;

TEST(ShapeRules, allLimits_areRead) {
  const ReadRules rules = readRules(
      "shapes:\n"
      "  - {link: arm_1, kinds: [capsule, box], max_shapes: 3, target_overshoot: 0.02,\n"
      "     padding: 0.001}\n");
  EXPECT_EQ(rules.errors, Texts());
  EXPECT_EQ(rules.warnings, Texts());
  const LinkRules& arm = rules.of("arm_1");
  EXPECT_FALSE(arm.kinds->sphere);
  EXPECT_TRUE(arm.kinds->capsule);
  EXPECT_TRUE(arm.kinds->box);
  EXPECT_FALSE(arm.kinds->rounded_box);
  EXPECT_EQ(arm.max_shapes, 3U);
  EXPECT_EQ(arm.target_overshoot, 0.02);
  EXPECT_EQ(arm.padding, 0.001);
  EXPECT_FALSE(arm.given);
  EXPECT_FALSE(rules.of("arm_2").kinds);
}

TEST(ShapeRules, refine_isOneOfThreeWords) {
  EXPECT_EQ(readFields("refine: mesh").of("arm_1").refine, RefineGeometry::mesh);
  EXPECT_EQ(readFields("refine: hull").of("arm_1").refine, RefineGeometry::hull);
  EXPECT_EQ(readFields("refine: none").of("arm_1").refine, RefineGeometry::none);
  EXPECT_EQ(readFields("padding: 1").of("arm_1").refine, std::nullopt);
}

TEST(ShapeRules, laterRules_overrideFieldByField) {
  const ReadRules rules = readRules(
      "shapes:\n"
      "  - {links: '*', max_shapes: 2, padding: 0.01}\n"
      "  - {links: ['arm_?', hand], max_shapes: 5}\n"
      "  - {link: hand, kinds: box}\n");
  EXPECT_EQ(rules.errors, Texts());
  EXPECT_EQ(rules.of("base").max_shapes, 2U);
  EXPECT_EQ(rules.of("arm_2").max_shapes, 5U);
  EXPECT_EQ(rules.of("hand").max_shapes, 5U);
  EXPECT_EQ(rules.of("hand").padding, 0.01);
  EXPECT_TRUE(rules.of("hand").kinds->box);
  EXPECT_FALSE(rules.of("hand").kinds->capsule);
}

TEST(ShapeRules, patterns_matchWholeNames) {
  EXPECT_EQ(readRules("shapes: [{links: 'arm_*', max_shapes: 1}]").withMaximum(),
            (Texts{"arm_1", "arm_2"}));
  EXPECT_EQ(readRules("shapes: [{links: ['*a*'], max_shapes: 1}]").withMaximum(),
            (Texts{"base", "arm_1", "arm_2", "hand"}));
  EXPECT_EQ(readRules("shapes: [{links: ['a?m_?', 'b?s*e'], max_shapes: 1}]").withMaximum(),
            (Texts{"base", "arm_1", "arm_2"}));
  EXPECT_EQ(readRules("shapes: [{links: [arm], max_shapes: 1}]").errors.size(), 1U);
}

TEST(ShapeRules, severalRobots_namesWithAndWithoutPrefix) {
  const auto selected = [](const std::string& selector) {
    return readRules("shapes: [{" + selector + ", max_shapes: 1}]", {"left", "right"})
        .withMaximum();
  };
  EXPECT_EQ(selected("link: hand"), (Texts{"left/hand", "right/hand"}));
  EXPECT_EQ(selected("link: left/hand"), Texts{"left/hand"});
  EXPECT_EQ(selected("links: 'right/arm*'"), (Texts{"right/arm_1", "right/arm_2"}));
  EXPECT_EQ(selected("group: tip"), (Texts{"left/hand", "left/tool", "right/hand", "right/tool"}));
  EXPECT_EQ(selected("group: left/tip"), (Texts{"left/hand", "left/tool"}));
}

TEST(ShapeRules, linksWithoutGeometry_areWarnedOfUnlessTheyHaveShapes) {
  EXPECT_EQ(readRules("shapes: [{link: tool, max_shapes: 2}]").warnings,
            Texts{"rules.yaml line 1, rule 1: links without geometry; the rule does nothing for "
                  "them; 'shapes' would give them some"});
  EXPECT_EQ(readRules("shapes:\n  - {link: tool, shapes: [{kind: sphere, radius: 1}]}\n"
                      "  - {link: tool, padding: 0.01}")
                .warnings,
            Texts());
}

TEST(ShapeRules, nothing_isNoRule) {
  EXPECT_EQ(readRules("").warnings.size(), 1U);
  EXPECT_EQ(readRules("# all commented out\n").warnings.size(), 1U);
  EXPECT_EQ(readRules("shapes:\n").warnings.size(), 1U);
  EXPECT_EQ(readRules("shapes: []\n").errors, Texts());
}

}  // namespace
}  // namespace collision_monitor
