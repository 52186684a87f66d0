// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>
#include <tuple>
#include <utility>

#include "memory_need.h"
#include "model/number_text.h"
#include "model/place.h"
#include "setup_parts.h"

namespace collision_monitor {
namespace {

void addOnce(const Problem& problem, std::vector<Problem>& problems) {
  const std::string text = toString(problem);
  if (std::none_of(problems.begin(), problems.end(),
                   [&](const Problem& other) { return toString(other) == text; })) {
    problems.push_back(problem);
  }
}

/// A larger tolerance could hide everything that warnings report.
void checkTolerance(double warning_distance, double tolerance, const std::string& where,
                    SetupReport& report) {
  if (tolerance > std::max(0.0, warning_distance)) {
    report.errors.push_back({where + "warning_distance", shortText(warning_distance) + " m",
                             "at least distance_tolerance, " + shortText(tolerance) + " m"});
  }
}

/// "rules.yaml line 3, rule 1: "
std::string whereOf(const OwnLimits& own, const std::vector<PairRule>& rules) {
  std::vector<std::string> places;
  for (const std::uint32_t rule : own.rules) {
    if (rule != kNone &&
        std::find(places.begin(), places.end(), rules[rule].where) == places.end()) {
      places.push_back(rules[rule].where);
    }
  }
  return joined(places) + ": ";
}

void checkOwnLimits(const std::vector<OwnLimits>& own_limits, const std::vector<PairRule>& rules,
                    double tolerance, SetupReport& report) {
  for (const OwnLimits& own : own_limits) {
    const std::string where = whereOf(own, rules);
    SetupReport of_these;
    checkLimits(own.limits, where, of_these);
    if (of_these.errors.empty()) {
      checkTolerance(own.limits.warning_distance, tolerance, where, of_these);
    }
    for (const Problem& problem : of_these.errors) {
      addOnce(problem, report.errors);
    }
  }
}

}  // namespace

void decideByRules(IdleRule idle, CycleSetup& setup, SetupReport& report) {
  reportIdleRules(setup.pair_rules, setup.link_pairs, idle, report);
  setup.own_limits = applyPairRules(setup.pair_rules, setup.limits, setup.link_pairs);
  checkOwnLimits(setup.own_limits, setup.pair_rules, setup.refine.tolerance, report);
  const double longest = largestOfLimits(
      setup, [](const Limits& limits) { return limits.warning_time + limits.time_hysteresis; });
  setup.ahead.horizon = std::max(setup.least_horizon, longest);
}

void checkPairRules(const CycleSetup& setup, const Limits& limits,
                    const std::vector<PairRule>& rules, SetupReport& report) {
  const double tolerance = setup.refine.tolerance;
  std::vector<LinkPair> pairs = withAskedPairs(setup, rules, report);
  checkLimits(limits, "", report);
  checkTolerance(limits.warning_distance, tolerance, "", report);
  reportIdleRules(rules, pairs, IdleRule::is_warning, report);
  checkOwnLimits(applyPairRules(rules, limits, pairs), rules, tolerance, report);
}

CycleSetup withPairRules(const CycleSetup& setup, const Limits& limits,
                         const std::vector<PairRule>& rules, SetupReport& report) {
  checkPairRules(setup, limits, rules, report);
  throwIfErrors(report);
  CycleSetup changed = withoutTables(setup, setup.model);
  changed.limits = limits;
  changed.pair_rules = rules;
  SetupReport known;
  changed.link_pairs = withAskedPairs(setup, rules, known);
  decideByRules(IdleRule::is_warning, changed, known);
  checkMemory(countPairs(changed), changed.memory_limit, report);
  throwIfErrors(report);
  listPairs(changed);
  return changed;
}

CycleSetup withPairs(const CycleSetup& setup, std::vector<LinkPair> wanted) {
  CycleSetup changed = withoutTables(setup, setup.model);
  for (LinkPair& pair : wanted) {
    pair.reason = PairReason::checked;
  }
  std::sort(wanted.begin(), wanted.end(), [](const LinkPair& one, const LinkPair& other) {
    return std::tie(one.a, one.b) < std::tie(other.a, other.b);
  });
  changed.link_pairs = std::move(wanted);
  listPairs(changed);
  return changed;
}

}  // namespace collision_monitor
