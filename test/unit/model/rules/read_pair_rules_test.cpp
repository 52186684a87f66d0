// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/robots/rules_text.h"

namespace collision_monitor::read_pair_rules {
namespace {

using test::ReadPairRulesText;
using test::readPairs;
using Names = std::vector<std::string>;

TEST(ReadPairRules, sides_areNamesPatternsGroupsAndLists) {
  const ReadPairRulesText read = readPairs(
      "pair_rules:\n"
      "- {a: base, b: 'arm_?', check: false}\n"
      "- {a: '*', b: {group: tip}, warning_distance: 0.01}\n"
      "- {a: [base, arm_1], b: [{group: tip}, arm_2], check: true}\n");
  ASSERT_EQ(read.errors, Names{});
  ASSERT_EQ(read.rules.size(), 3U);
  EXPECT_EQ(read.names(read.rules[0].a), Names{"base"});
  EXPECT_EQ(read.names(read.rules[0].b), (Names{"arm_1", "arm_2"}));
  EXPECT_EQ(read.names(read.rules[1].a), (Names{"base", "arm_1", "arm_2", "hand", "tool"}));
  EXPECT_EQ(read.names(read.rules[1].b), (Names{"hand", "tool"}));
  EXPECT_EQ(read.names(read.rules[2].b), (Names{"arm_2", "hand", "tool"}));
  EXPECT_EQ(read.rules[0].is_checked, false);
  EXPECT_EQ(read.rules[1].is_checked, std::nullopt);
  EXPECT_EQ(read.rules[2].is_checked, true);
  EXPECT_EQ(read.rules[2].where, "rules.yaml line 4, rule 3");
}

TEST(ReadPairRules, limits_areReadByName) {
  const ReadPairRulesText read = readPairs(
      "- a: base\n  b: hand\n  contact_distance: -0.01\n  warning_distance: 0.02\n"
      "  hysteresis: 0.001\n  report_distance: 0.3\n  contact_time: 0.1\n  warning_time: 0.2\n"
      "  time_hysteresis: 0.03\n");
  ASSERT_EQ(read.errors, Names{});
  Limits limits;
  change(read.rules.at(0).limits, limits);
  EXPECT_EQ(limits.contact_distance, -0.01);
  EXPECT_EQ(limits.warning_distance, 0.02);
  EXPECT_EQ(limits.hysteresis, 0.001);
  EXPECT_EQ(limits.report_distance, 0.3);
  EXPECT_EQ(limits.contact_time, 0.1);
  EXPECT_EQ(limits.warning_time, 0.2);
  EXPECT_EQ(limits.time_hysteresis, 0.03);
}

TEST(ReadPairRules, noText_isNoRule) {
  EXPECT_TRUE(readPairs("").rules.empty());
  EXPECT_TRUE(readPairs("pair_rules:\n").errors.empty());
}

/// The only error of a text.
std::string errorOf(const std::string& yaml) {
  const ReadPairRulesText read = readPairs(yaml);
  EXPECT_EQ(read.errors.size(), 1U) << yaml;
  return read.errors.empty() ? "" : read.errors.front();
}

TEST(ReadPairRules, faults_areNamedWithTheirLine) {
  const auto expectError = [](const std::string& yaml, const std::string& part) {
    const std::string error = errorOf(yaml);
    EXPECT_NE(error.find(part), std::string::npos) << error;
  };
  expectError("- {a: base, check: true}", "rules.yaml line 1, rule 1: a rule without 'b'");
  expectError("- {a: base, b: hand}", "a rule that sets nothing");
  expectError("- {a: base, b: hand, check: maybe}", "check 'maybe'");
  expectError("- {a: base, b: hand, warnign_distance: 0.1, check: true}",
              "an unknown key, 'warnign_distance'");
  expectError("- {a: base, b: hand, warnign_distance: 0.1}", "an unknown key");
  expectError("- {a: base, b: hand, hysteresis: -0.1}", "hysteresis '-0.1'");
  expectError("- {a: base, b: hand, warning_distance: .nan}", "warning_distance '.nan'");
  expectError("-\n  a: base\n  b: hnad\n  check: false\n",
              "rules.yaml line 3, rule 1: link 'hnad', which matches none");
  expectError("- {a: tip, b: base, check: false}", "{group: tip}");
  expectError("- {a: base, b: {group: void}, check: false}", "group 'void', which is empty");
  expectError("- {a: base, b: {group: hands}, check: false}", "group 'hands', which is unknown");
  expectError("- {a: base, b: [], check: false}", "b []");
  expectError("- {a: *, b: base, check: false}", "patterns stand in quotes");
  expectError("pair_rules: 3", "pair_rules '3'");
  expectError("- base", "'base'");
}

TEST(ReadPairRules, nameThatMatchesNothing_isAWarningAtRunTime) {
  const ReadPairRulesText read =
      readPairs("- {a: base, b: hnad, check: false}", IdleRule::is_warning);
  EXPECT_EQ(read.errors, Names{});
  ASSERT_EQ(read.warnings.size(), 1U);
  EXPECT_NE(read.warnings[0].find("link 'hnad', which matches none"), std::string::npos);
}

/// Pairs of the arm as the rules leave them.
std::vector<LinkPair> decide(const ReadPairRulesText& read, std::vector<OwnLimits>& own) {
  std::vector<LinkPair> pairs = decideLinkPairs(read.model, {});
  own = applyPairRules(read.rules, Limits(), pairs);
  return pairs;
}

const LinkPair& pairOf(const ReadPairRulesText& read, const std::vector<LinkPair>& pairs,
                       const std::string& a, const std::string& b) {
  for (const LinkPair& pair : pairs) {
    if (read.model.link(pair.a).name == a && read.model.link(pair.b).name == b) {
      return pair;
    }
  }
  throw std::out_of_range(a + " " + b);
}

TEST(ApplyPairRules, lastRuleThatSetsAField_decidesIt) {
  const ReadPairRulesText read = readPairs(
      "- {a: '*', b: '*', warning_distance: 0.03, hysteresis: 0.001}\n"
      "- {a: hand, b: base, warning_distance: 0.02, check: false}\n"
      "- {a: base, b: 'h*', check: true}\n");
  ASSERT_EQ(read.errors, Names{});
  std::vector<OwnLimits> own;
  const std::vector<LinkPair> pairs = decide(read, own);
  ASSERT_EQ(own.size(), 2U);
  const LinkPair& ruled = pairOf(read, pairs, "base", "hand");
  EXPECT_EQ(ruled.reason, PairReason::checked_by_rule);
  EXPECT_EQ(ruled.rule, 2U);
  const OwnLimits& limits = own.at(ruled.limits - 1);
  EXPECT_EQ(limits.limits.warning_distance, 0.02);
  EXPECT_EQ(limits.limits.hysteresis, 0.001);
  EXPECT_EQ(limits.limits.report_distance, Limits().report_distance);
  EXPECT_EQ(limits.rules[1], 1U);
  EXPECT_EQ(limits.rules[2], 0U);
  EXPECT_EQ(limits.rules[3], kNone);
  const LinkPair& other = pairOf(read, pairs, "base", "arm_2");
  EXPECT_EQ(other.reason, PairReason::checked);
  EXPECT_EQ(other.rule, kNone);
  EXPECT_EQ(own.at(other.limits - 1).limits.warning_distance, 0.03);
}

TEST(ApplyPairRules, rules_winOverAdjacencyAndAreTakenBack) {
  ReadPairRulesText read = readPairs("- {a: base, b: arm_1, check: true}\n");
  std::vector<OwnLimits> own;
  std::vector<LinkPair> pairs = decide(read, own);
  EXPECT_EQ(pairOf(read, pairs, "base", "arm_1").reason, PairReason::checked_by_rule);
  applyPairRules({}, Limits(), pairs);
  EXPECT_EQ(pairOf(read, pairs, "base", "arm_1").reason, PairReason::adjacent);
}

TEST(ApplyPairRules, mute_ignoresOnlyWhatIsChecked) {
  ReadPairRulesText read = readPairs("- {a: base, b: '*', check: false}\n");
  read.rules[0].ends = true;
  std::vector<OwnLimits> own;
  const std::vector<LinkPair> pairs = decide(read, own);
  EXPECT_EQ(pairOf(read, pairs, "base", "hand").reason, PairReason::muted);
  EXPECT_EQ(pairOf(read, pairs, "base", "arm_1").reason, PairReason::adjacent);
}

TEST(ApplyPairRules, idleRules_areReported) {
  const ReadPairRulesText read = readPairs(
      "- {a: base, b: base, check: false}\n- {a: base, b: tool, check: false}\n"
      "- {a: base, b: hand, check: false}\n");
  SetupReport report;
  reportIdleRules(read.rules, decideLinkPairs(read.model, {}), IdleRule::is_error, report);
  ASSERT_EQ(report.errors.size(), 2U);
  EXPECT_EQ(report.errors[0].where, "rules.yaml line 1, rule 1");
  EXPECT_EQ(report.errors[1].where, "rules.yaml line 2, rule 2");
}

}  // namespace
}  // namespace collision_monitor::read_pair_rules
