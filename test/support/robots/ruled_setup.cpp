// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/robots/ruled_setup.h"

#include "pipeline/setup/setup_parts.h"

namespace collision_monitor::test {

PairRule ruleForAll(const Limits& limits, const CycleSetup& setup) {
  PairRule rule;
  rule.a.assign(setup.model.links.size(), true);
  rule.b = rule.a;
  for (std::size_t i = 0; i < kLimitFields.size(); ++i) {
    rule.limits[i] = limits.*kLimitFields[i].value;
  }
  rule.where = "a test";
  return rule;
}

PairRule ruleForSome(const Limits& limits, const CycleSetup& setup, Random& random) {
  PairRule rule = ruleForAll(limits, setup);
  for (std::vector<bool>* side : {&rule.a, &rule.b}) {
    for (std::size_t i = 0; i < side->size(); ++i) {
      (*side)[i] = random() % 5 < 2;
    }
  }
  return rule;
}

Limits randomLimits(Random& random) {
  Limits limits;
  limits.contact_distance = random() % 2 == 0 ? 0.0 : uniform(random, 0.0, 0.02);
  limits.warning_distance = limits.contact_distance + uniform(random, 0.0, 0.1);
  limits.report_distance = limits.warning_distance + uniform(random, 0.0, 0.3);
  limits.hysteresis = uniform(random, 0.0, 0.02);
  limits.contact_time = random() % 2 == 0 ? 0.0 : uniform(random, 0.0, 0.1);
  limits.warning_time = limits.contact_time + uniform(random, 0.0, 0.2);
  limits.time_hysteresis = uniform(random, 0.0, 0.1);
  return limits;
}

void giveRules(const std::vector<PairRule>& rules, CycleSetup& setup) {
  setup.pair_rules = rules;
  setup.own_limits = applyPairRules(rules, setup.limits, setup.link_pairs);
  listPairs(setup);
}

}  // namespace collision_monitor::test
