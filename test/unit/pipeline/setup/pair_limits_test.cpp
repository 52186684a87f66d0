// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "collision_monitor/pipeline/setup.h"
#include "pipeline/answers/pair_reason.h"
#include "support/robots/urdf_text.h"

// What rules for pairs, and what MoveIt's files say of shapes, make of a set-up.
namespace collision_monitor::test::pair_limits_setup {
namespace {

/// Balls a, b, c of radius 0.1 m in a row, 1 m apart; b and c turn.
RobotDescription threeBalls() {
  const std::string ball = "<sphere radius='0.1'/>";
  const std::string ahead = "<origin xyz='1 0 0'/>";
  RobotDescription description = describeText(robotXml(
      linkXml("a", ball) + linkXml("b", ball) + linkXml("c", ball) +
      jointXml("j", "continuous", "a", "b", ahead) + jointXml("k", "continuous", "b", "c", ahead)));
  description.srdf_xml =
      "<robot name='r'>\n<link_sphere_approximation link='c'><sphere center='0 0 0' radius='0.2'/>"
      "</link_sphere_approximation>\n"
      "<disable_collisions link1='c' link2='a' reason='Never'/></robot>";
  description.srdf_source = "test.srdf";
  return description;
}

CycleSetup setupOf(const SetupOptions& options) {
  return buildSetup({threeBalls()}, textLoader({}), options);
}

const LinkPair& pairOf(const CycleSetup& setup, const std::string& a, const std::string& b) {
  return setup.link_pairs.at(
      findLinkPair(setup, *setup.model.findLink(a), *setup.model.findLink(b)));
}

SetupOptions ruled(const std::string& yaml) {
  SetupOptions options;
  options.pair_rules = {"rules.yaml", yaml};
  return options;
}

std::string faultsOf(const SetupOptions& options) {
  try {
    setupOf(options);
  } catch (const SetupError& error) {
    return error.what();
  }
  return "";
}

TEST(PairLimitsOfSetup, rules_decideWhatIsCheckedAndByWhichLimits) {
  const CycleSetup setup = setupOf(
      ruled("- {a: a, b: c, check: true}\n- {a: '*', b: b, check: true, warning_distance: 0.01}"));
  ASSERT_EQ(setup.checked.size(), 3U);
  EXPECT_EQ(setup.own_limits.size(), 1U);
  EXPECT_EQ(limitsOf(setup, 0).warning_distance, 0.01);  // a and b
  EXPECT_EQ(limitsOf(setup, 1).warning_distance, Limits().warning_distance);
  EXPECT_EQ(reasonOf(setup, pairOf(setup, "a", "c")),
            "checked: a rule for pairs (rules.yaml line 1, rule 1)");
}

TEST(PairLimitsOfSetup, lineOfTheSrdf_isNamed) {
  const CycleSetup setup = setupOf(SetupOptions());
  EXPECT_EQ(reasonOf(setup, pairOf(setup, "a", "c")),
            "ignored: a line of the SRDF (test.srdf line 3, Never)");
}

TEST(PairLimitsOfSetup, defaultOfTheSrdf_isNamedWithItsLine) {
  RobotDescription description = threeBalls();
  description.srdf_xml =
      "<robot name='r'>\n\n<disable_default_collisions link='c'/>\n"
      "<enable_collisions link1='b' link2='c'/></robot>";
  const CycleSetup setup = buildSetup({description}, textLoader({}), SetupOptions());
  EXPECT_EQ(reasonOf(setup, pairOf(setup, "a", "c")),
            "ignored: a line of the SRDF (test.srdf line 3, disable_default_collisions of c)");
  EXPECT_EQ(reasonOf(setup, pairOf(setup, "b", "c")).find("disable"), std::string::npos);
}

TEST(PairLimitsOfSetup, horizon_isThatOfTheLongestWarningTime) {
  const CycleSetup setup = setupOf(ruled("- {a: a, b: c, warning_time: 2.0}"));
  EXPECT_DOUBLE_EQ(setup.ahead.horizon, 2.0 + Limits().time_hysteresis);
}

TEST(PairLimitsOfSetup, horizon_shrinksWhenLongTimesEnd) {
  const CycleSetup setup = setupOf(ruled("- {a: a, b: c, warning_time: 2.0}"));
  SetupReport report;
  const CycleSetup changed = withPairRules(setup, setup.limits, {}, report);
  EXPECT_DOUBLE_EQ(changed.ahead.horizon, setupOf(SetupOptions()).ahead.horizon);
}

TEST(PairLimitsOfSetup, changedRules_obeyTheLimitOfMemory) {
  CycleSetup setup = setupOf(SetupOptions());
  setup.memory_limit = 1;
  SetupReport report;
  EXPECT_THROW(withPairRules(setup, setup.limits, {}, report), SetupError);
}

TEST(PairLimitsOfSetup, faults_areErrorsThatNameTheRule) {
  EXPECT_NE(faultsOf(ruled("- {a: a, b: a, check: true}"))
                .find("rules.yaml line 1, rule 1: a rule that selects no pair"),
            std::string::npos);
  EXPECT_NE(faultsOf(ruled("- {a: a, b: c, contact_distance: 0.1}"))
                .find("rules.yaml line 1, rule 1: warning_distance: 0.05 m"),
            std::string::npos);
  const std::string of_two = faultsOf(
      ruled("- {a: a, b: '*', warning_distance: 0.1}\n- {a: c, b: '*', report_distance: 0.05}"));
  EXPECT_NE(of_two.find("rules.yaml line 1, rule 1 and rules.yaml line 2, rule 2: report_distance"),
            std::string::npos)
      << of_two;
}

TEST(PairLimitsOfSetup, withPairRules_equalsASetupBuiltWithThem) {
  const std::string yaml = "- {a: a, b: '*', check: true, warning_distance: 0.02}";
  const CycleSetup built = setupOf(ruled(yaml));
  const CycleSetup plain = setupOf(SetupOptions());
  SetupReport report;
  const CycleSetup changed = withPairRules(plain, plain.limits, built.pair_rules, report);
  EXPECT_TRUE(report.warnings.empty());
  ASSERT_EQ(changed.checked.size(), built.checked.size());
  for (std::size_t i = 0; i < built.checked.size(); ++i) {
    EXPECT_EQ(changed.checked[i].a, built.checked[i].a);
    EXPECT_EQ(changed.checked[i].b, built.checked[i].b);
    EXPECT_EQ(changed.checked[i].limits, built.checked[i].limits);
  }
  EXPECT_EQ(changed.table.size(), built.table.size());
  const CycleSetup back = withPairRules(changed, plain.limits, {}, report);
  EXPECT_EQ(back.checked.size(), plain.checked.size());
  EXPECT_TRUE(back.own_limits.empty());
}

TEST(PairLimitsOfSetup, overlapInTheDefaultPose_staysCheckedIfARuleSaysSo) {
  RobotDescription description = threeBalls();
  description.srdf_xml.clear();
  const std::size_t ahead = description.urdf_xml.rfind("xyz='1 0 0'");
  description.urdf_xml.replace(ahead, 11, "xyz='-1 0 0'");  // c lies in a
  const auto build = [&](const SetupOptions& options) {
    return buildSetup({description}, textLoader({}), options);
  };
  EXPECT_EQ(pairOf(build(SetupOptions()), "a", "c").reason, PairReason::default_overlap);
  const CycleSetup forced = build(ruled("- {a: a, b: c, check: true}"));
  EXPECT_EQ(pairOf(forced, "a", "c").reason, PairReason::checked_by_rule);
  EXPECT_EQ(pairOf(forced, "a", "c").without_rules, PairReason::default_overlap);
}

std::string textOf(const std::vector<Problem>& problems) {
  std::string text;
  for (const Problem& problem : problems) {
    text += toString(problem) + "\n";
  }
  return text;
}

TEST(PairLimitsOfSetup, spheresOfTheSrdf_replaceFitsWhenAskedFor) {
  SetupOptions options;
  EXPECT_EQ(radiusOf(setupOf(options).bodies.back().shape), 0.1);
  options.uses_srdf_spheres = true;
  const CycleSetup setup = setupOf(options);
  EXPECT_EQ(radiusOf(setup.bodies.back().shape), 0.2);
  EXPECT_EQ(textOf(setup.report.warnings).find("link_sphere"), std::string::npos);
}

TEST(PairLimitsOfSetup, spheresThatDoNotEncloseTheirLink_areTakenWithAWarning) {
  RobotDescription description = threeBalls();
  const std::size_t radius = description.srdf_xml.find("radius='0.2'");
  description.srdf_xml.replace(radius, 12, "radius='.05'");
  SetupOptions options;
  options.uses_srdf_spheres = true;
  const CycleSetup setup = buildSetup({description}, textLoader({}), options);
  EXPECT_EQ(radiusOf(setup.bodies.back().shape), 0.05);
  EXPECT_FALSE(setup.labels.back().is_proven);
  EXPECT_NE(textOf(setup.report.warnings)
                .find("test.srdf line 2, link_sphere_approximation, shapes of link 'c': collision "
                      "'collision_0' is 50 mm outside"),
            std::string::npos)
      << textOf(setup.report.warnings);
}

TEST(PairLimitsOfSetup, paddings_areThoseOfNamedLinks) {
  SetupOptions options;
  options.link_paddings = {{"b", 0.05}};
  EXPECT_NEAR(radiusOf(setupOf(options).bodies[1].shape), 0.15, 1e-12);
  EXPECT_NEAR(radiusOf(setupOf(options).bodies[2].shape), 0.1, 1e-12);
  options.where = "parameter /m/";
  options.link_paddings = {{"x", 0.05}, {"a", -1.0}};
  const std::string faults = faultsOf(options);
  EXPECT_NE(faults.find("parameter /m/link_padding/x: link 'x', which matches none"),
            std::string::npos);
  EXPECT_NE(faults.find("parameter /m/link_padding/a: -1 m"), std::string::npos);
}

}  // namespace
}  // namespace collision_monitor::test::pair_limits_setup
