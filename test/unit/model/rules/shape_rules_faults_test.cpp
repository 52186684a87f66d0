// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "collision_monitor/model/shape_rules.h"
#include "support/robots/rules_text.h"

namespace collision_monitor {
namespace {

using test::readFields;
using test::readRules;
using test::ReadRules;
using Texts = std::vector<std::string>;

TEST(ShapeRulesFaults, noYaml_isOneErrorWithItsLine) {
  const Texts errors = readRules("shapes:\n  - {link: arm_1\n").errors;
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].rfind("rules.yaml line 3: text that is no YAML: ", 0), 0U) << errors[0];
  EXPECT_EQ(readRules("\t- x").errors.size(), 1U);
  EXPECT_EQ(readRules("shapes: *nowhere").errors.size(), 1U);
}

TEST(ShapeRulesFaults, wrongOutline_isNamed) {
  EXPECT_EQ(readRules("[1, 2]").errors,
            Texts{"rules.yaml line 1: [1, 2]; accepted: YAML with a list of rules under 'shapes'"});
  EXPECT_EQ(readRules("shape: []").errors,
            (Texts{"rules.yaml line 1: an unknown key, 'shape'; accepted: shapes",
                   "rules.yaml line 1: no 'shapes'; accepted: YAML with a list of rules under "
                   "'shapes'"}));
  EXPECT_EQ(readRules("shapes: {link: a}").errors,
            Texts{"rules.yaml line 1: shapes a map of 1; accepted: a list of rules"});
  EXPECT_EQ(readRules("shapes: [arm_1]").errors,
            Texts{"rules.yaml line 1, rule 1: 'arm_1'; accepted: a rule with its fields"});
}

TEST(ShapeRulesFaults, everyProblemOfTheFile_isReportedWithItsLine) {
  const ReadRules rules = readRules(
      "shapes:\n"
      "  - link: elbow\n"
      "    max_shapes: 2.5\n"
      "  - links: [arm_1, 'leg_*']\n"
      "    padding: -0.1\n"
      "    paddding: 1\n"
      "  - group: tail\n"
      "    kinds: [ball]\n"
      "  - max_shapes: 1\n"
      "  - link: base\n"
      "    group: tip\n"
      "  - group: void\n"
      "    target_overshoot: .nan\n");
  EXPECT_EQ(
      rules.errors,
      (Texts{
          "rules.yaml line 2, rule 1: link 'elbow', which is unknown; accepted: links of the "
          "robots: 'base', 'arm_1', 'arm_2', 'hand' and 'tool'",
          "rules.yaml line 3, rule 1: max_shapes '2.5'; accepted: a whole number",
          "rules.yaml line 4, rule 2: links 'leg_*', which matches none; accepted: links of the "
          "robots: 'base', 'arm_1', 'arm_2', 'hand' and 'tool'",
          "rules.yaml line 5, rule 2: padding '-0.1'; accepted: a number from 0 to 1000",
          "rules.yaml line 6, rule 2: an unknown key, 'paddding'; accepted: group, kinds, link, "
          "links, max_shapes, padding, refine, shapes, target_overshoot and unproven",
          "rules.yaml line 7, rule 3: group 'tail'; accepted: a group of an SRDF: 'tip' and "
          "'void'",
          "rules.yaml line 8, rule 3: kinds [ball]; accepted: a list of sphere, capsule, box and "
          "rounded_box",
          "rules.yaml line 9, rule 4: a rule without links; accepted: one of link, links and group",
          "rules.yaml line 10, rule 5: two selections of links; accepted: one of link, links and "
          "group",
          "rules.yaml line 10, rule 5: a rule that sets nothing; accepted: kinds, max_shapes, "
          "target_overshoot, padding, refine or shapes",
          "rules.yaml line 12, rule 6: group 'void'; accepted: a group that has links",
          "rules.yaml line 13, rule 6: target_overshoot '.nan'; accepted: a number from 0 to "
          "1e+06"}));
}

TEST(ShapeRulesFaults, wrongValues_areRefused) {
  for (const char* fields : {"max_shapes: 0",
                             "max_shapes: 1001",
                             "max_shapes: -1",
                             "max_shapes: many",
                             "max_shapes: [1]",
                             "padding: .inf",
                             "padding: 1e999",
                             "padding: 0x10",
                             "padding: {a: 1}",
                             "padding:",
                             "target_overshoot: -1e-9",
                             "kinds: []",
                             "kinds: [[box]]",
                             "kinds: Box",
                             "refine: exact",
                             "refine: [mesh]",
                             "unproven: true",
                             "shapes: []",
                             "shapes: {kind: sphere, radius: 1}",
                             "shapes: 3"}) {
    EXPECT_EQ(readFields(fields).errors.size(), 1U) << fields;
  }
  EXPECT_EQ(readFields("padding: 1\n    padding: 2").errors,
            Texts{"rules.yaml line 4, rule 1: padding a second time; accepted: each key once"});
  EXPECT_EQ(readFields("padding: 1\n    [1]: 2").errors.size(), 1U) << "a key that is a list";
}

}  // namespace
}  // namespace collision_monitor
