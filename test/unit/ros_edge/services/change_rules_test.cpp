// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/services/change_rules.h"

#include <gtest/gtest.h>

#include <limits>

#include "pipeline/answers/pair_reason.h"
#include "unit/ros_edge/world_scene.h"

namespace collision_monitor::test::change_rules {
namespace {

using std::chrono::seconds;

/// The sliding robot, whose rules and limits services change.
class ChangeRules : public testing::Test {
 protected:
  SetPairs::Response setPairs(const std::string& rules, double duration = 0.0,
                              std::uint8_t action = SetPairs::Request::APPEND) {
    SetPairs::Request request;
    request.rules = rules;
    request.action = action;
    request.duration = duration;
    SetPairs::Response response;
    take(answerSetPairs(*current_, now_, 7, request, response));
    return response;
  }
  SetLimits::Response setLimits(const std::vector<std::string>& names,
                                const std::vector<double>& values) {
    SetLimits::Request request;
    request.names = names;
    request.values = values;
    SetLimits::Response response;
    take(answerSetLimits(*current_, request, response));
    return response;
  }
  NextSetup endRules(RuleEnd now) { return withoutEnded(*current_, now, dropped_limits_); }
  void take(const NextSetup& next) { current_ = next ? next : current_; }

  const LinkPair& pairOf(const std::string& a, const std::string& b) const {
    const CycleSetup& setup = current_->setup;
    return setup.link_pairs.at(
        findLinkPair(setup, linkNamed(setup.model, a), linkNamed(setup.model, b)));
  }

  NextSetup current_ = slidingSetup();
  RuleEnd now_ = RuleEnd() + seconds(1000);
  std::vector<Problem> dropped_limits_;
};

TEST_F(ChangeRules, appendedRules_followThoseBefore) {
  EXPECT_TRUE(setPairs("- {a: base, b: tool, check: false, warning_distance: 0.02}").success);
  EXPECT_TRUE(setPairs("- {a: base, b: '*', warning_distance: 0.03}").success);
  EXPECT_EQ(current_->setup.pair_rules.size(), 2U);
  EXPECT_EQ(pairOf("base", "tool").reason, PairReason::ignored_by_rule);
  EXPECT_EQ(limitsOf(current_->setup, pairOf("base", "tool")).warning_distance, 0.03);
  EXPECT_EQ(reasonOf(current_->setup, pairOf("base", "tool")),
            "ignored: a rule for pairs (set_pairs request 7 line 1, rule 1)");
  EXPECT_EQ(current_->setup.checked.size(), 2U);
}

TEST_F(ChangeRules, replacingRules_endThoseBefore) {
  setPairs("- {a: base, b: tool, check: false}");
  setPairs("- {a: base, b: finger, check: false}", 0.0, SetPairs::Request::REPLACE);
  EXPECT_EQ(pairOf("base", "tool").reason, PairReason::checked);
  EXPECT_EQ(pairOf("base", "finger").reason, PairReason::ignored_by_rule);
  const SetPairs::Response none = setPairs("", 0.0, SetPairs::Request::REPLACE);
  EXPECT_EQ(none.pairs_checked, 3U);
  EXPECT_TRUE(current_->setup.own_limits.empty());
}

TEST_F(ChangeRules, rulesThatLast_areNotSaidToEnd) {
  setPairs("- {a: base, b: finger, check: false}");
  const SetPairs::Response response = setPairs("", 1.0);
  ASSERT_TRUE(response.success) << response.message;
  EXPECT_EQ(response.message.find("1 rule; "), 0U) << response.message;
  EXPECT_EQ(response.message.find(" in 1"), std::string::npos) << response.message;
}

TEST_F(ChangeRules, mute_endsByItself) {
  const SetPairs::Response response = setPairs("- {a: base, b: '*', check: false}", 12.5);
  ASSERT_TRUE(response.success) << response.message;
  EXPECT_EQ(response.pairs_muted, 2U);
  EXPECT_EQ(response.pairs_checked, 1U);
  EXPECT_NE(response.message.find("; 1 of them ends in 12.500 s"), std::string::npos)
      << response.message;
  const RuleEnd end = now_ + std::chrono::milliseconds(12500);
  EXPECT_EQ(nextEndOf(*current_), end);
  EXPECT_EQ(lastMuteOf(*current_), end);
  EXPECT_EQ(endRules(end - seconds(1)), nullptr);
  const NextSetup later = endRules(end);
  ASSERT_NE(later, nullptr);
  EXPECT_EQ(later->setup.checked.size(), 3U);
  EXPECT_EQ(nextEndOf(*later), kLasts);
  EXPECT_EQ(lastMuteOf(*later), std::nullopt);
}

TEST_F(ChangeRules, endingOneRule_leavesTheOthers) {
  setPairs("- {a: tool, b: finger, check: false}");
  setPairs("- {a: base, b: tool, check: false}", 5.0);
  setPairs("- {a: base, b: finger, check: false}", 50.0);
  take(endRules(now_ + seconds(10)));
  EXPECT_EQ(pairOf("tool", "finger").reason, PairReason::ignored_by_rule);
  EXPECT_EQ(pairOf("base", "tool").reason, PairReason::checked);
  EXPECT_EQ(pairOf("base", "finger").reason, PairReason::muted);
}

TEST_F(ChangeRules, emptyListWithADuration_endsMutesAlone) {
  setPairs("- {a: tool, b: finger, check: false}");
  setPairs("- {a: base, b: tool, check: false}", 50.0);
  setPairs("[]", 1.0, SetPairs::Request::REPLACE);
  EXPECT_EQ(pairOf("tool", "finger").reason, PairReason::ignored_by_rule);
  EXPECT_EQ(pairOf("base", "tool").reason, PairReason::checked);
}

TEST_F(ChangeRules, idleRule_isAWarning) {
  const SetPairs::Response response = setPairs("- {a: base, b: base, check: false}");
  EXPECT_TRUE(response.success);
  EXPECT_NE(response.message.find("a rule that selects no pair"), std::string::npos)
      << response.message;
}

TEST_F(ChangeRules, aNameThatMatchesNothing_isToldOnce) {
  const SetPairs::Response response = setPairs("- {a: base, b: nobody, check: false}");
  EXPECT_TRUE(response.success);
  EXPECT_NE(response.message.find("link 'nobody', which matches none"), std::string::npos)
      << response.message;
  EXPECT_EQ(response.message.find("a rule that selects no pair"), std::string::npos)
      << response.message;
}

TEST_F(ChangeRules, faultyRules_changeNothing) {
  const NextSetup before = current_;
  const auto expectRefused = [&](const SetPairs::Response& response, const std::string& part) {
    EXPECT_FALSE(response.success);
    EXPECT_NE(response.message.find("nothing was changed"), std::string::npos);
    EXPECT_NE(response.message.find(part), std::string::npos) << response.message;
    EXPECT_EQ(current_, before);
  };
  expectRefused(setPairs("- {a: base, b: tool, check: x}"), "line 1, rule 1: check 'x'");
  expectRefused(setPairs("- {a: base, b: tool, warning_distance: -0.1}"),
                "set_pairs request 7 line 1, rule 1: warning_distance");
  expectRefused(setPairs("[]", -1.0), "duration");
  expectRefused(setPairs("[]", std::numeric_limits<double>::quiet_NaN()), "duration");
  expectRefused(setPairs("[]", 1e6), "duration");
  expectRefused(setPairs("[]", 0.0, 2), "action");
}

TEST_F(ChangeRules, limits_changeForPairsWithoutTheirOwn) {
  setPairs("- {a: base, b: tool, warning_distance: 0.01}");
  const SetLimits::Response response = setLimits({"warning_distance", "contact_time"}, {0.1, 0.05});
  ASSERT_TRUE(response.success) << response.message;
  EXPECT_EQ(limitsOf(current_->setup, pairOf("base", "tool")).warning_distance, 0.01);
  EXPECT_EQ(limitsOf(current_->setup, pairOf("base", "tool")).contact_time, 0.05);
  EXPECT_EQ(limitsOf(current_->setup, pairOf("base", "finger")).warning_distance, 0.1);
}

TEST_F(ChangeRules, faultyLimits_areAllNamedAndChangeNothing) {
  const NextSetup before = current_;
  const auto expectRefused = [&](const SetLimits::Response& response,
                                 const std::vector<std::string>& parts) {
    EXPECT_FALSE(response.success);
    for (const std::string& part : parts) {
      EXPECT_NE(response.message.find(part), std::string::npos) << response.message;
    }
    EXPECT_EQ(current_, before);
  };
  expectRefused(setLimits({}, {}), {"0 names and 0 values"});
  expectRefused(setLimits({"hysteresis"}, {}), {"1 name and 0 values"});
  expectRefused(setLimits({"hysteresis", "hysteresis", "warnign_distance", "contact_time"},
                          {0.1, 0.1, 0.1, std::numeric_limits<double>::infinity()}),
                {"a second time", "did you mean 'warning_distance'?", "contact_time: inf s"});
  expectRefused(setLimits({"contact_distance", "warning_time"}, {0.1, 0.0}),
                {"warning_distance: 0.05 m"});
}

TEST_F(ChangeRules, ofManyFaults_theFirstAreNamedAndTheOthersCounted) {
  std::vector<std::string> names;
  for (int i = 0; i < 20'000; ++i) {
    names.push_back("limit_" + std::to_string(i));
  }
  const std::vector<double> values(names.size(), 0.1);
  const SetLimits::Response response = setLimits(names, values);
  EXPECT_FALSE(response.success);
  EXPECT_LT(response.message.size(), 20'000U);
  EXPECT_NE(response.message.find("'limit_49', which is no limit"), std::string::npos);
  EXPECT_NE(response.message.find("and 19950 more"), std::string::npos) << response.message;
}

TEST_F(ChangeRules, limitThatContradictsARule_namesTheRule) {
  setPairs("- {a: base, b: tool, warning_distance: 0.01}");
  const SetLimits::Response response = setLimits({"contact_distance"}, {0.02});
  EXPECT_FALSE(response.success);
  EXPECT_NE(response.message.find("set_pairs request 7 line 1, rule 1: warning_distance: 0.01 m"),
            std::string::npos)
      << response.message;
}

TEST_F(ChangeRules, limitThatWouldContradictOnceARuleEnds_isRefusedNow) {
  setPairs("- {a: base, b: tool, warning_distance: 0.01}");
  setPairs("- {a: base, b: tool, warning_distance: 0.05}", 10.0);
  EXPECT_FALSE(setLimits({"contact_distance"}, {0.02}).success);
}

TEST_F(ChangeRules, limitsThatNoLongerFitWhenARuleEnds_areDroppedAloneAndTold) {
  current_ = slidingSetupWith({});
  setPairs("- {a: base, b: tool, warning_distance: 0.03}");
  setPairs("- {a: tool, b: part, contact_distance: 0.06}");
  setPairs("- {a: tool, b: part, warning_distance: 0.1}", 10.0);
  ASSERT_EQ(current_->setup.pair_rules.size(), 3U);
  const World world = worldOf({objectOf("part", Sphere{0.05}, at(0, 0, 9))},
                              placesOf(current_->robots->model, current_->world_frame));
  current_ = changeWorld(*current_, world, {});
  ASSERT_EQ(limitsOf(current_->setup, pairOf("tool", "part")).contact_distance, 0.06);
  take(endRules(now_ + seconds(20)));
  EXPECT_EQ(limitsOf(current_->setup, pairOf("tool", "part")).contact_distance, 0.0);
  EXPECT_EQ(limitsOf(current_->setup, pairOf("base", "tool")).warning_distance, 0.03);
  ASSERT_EQ(dropped_limits_.size(), 1U);
  EXPECT_NE(toString(dropped_limits_[0]).find("its limits are dropped"), std::string::npos);
}

}  // namespace
}  // namespace collision_monitor::test::change_rules
