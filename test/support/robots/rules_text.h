// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "collision_monitor/model/pair_rules.h"
#include "collision_monitor/model/shape_rules.h"

namespace collision_monitor::test {

/// Rules for shapes read from text, with all messages. All robots are the same arm: base, arm_1,
/// arm_2, hand, tool, where the tool has no geometry. Its SRDF has the groups tip (hand and tool)
/// and void.
struct ReadRules {
  RobotModel model;
  std::vector<LinkRules> rules;
  std::vector<std::string> errors;
  std::vector<std::string> warnings;

  const LinkRules& of(const std::string& link) const;
  /// The links for which the rules set a maximum of shapes.
  std::vector<std::string> withMaximum() const;
};

/// One robot per prefix; the text is called "rules.yaml".
ReadRules readRules(const std::string& yaml, const std::vector<std::string>& prefixes = {""});

/// As above, with one rule for the link "arm_1"; the fields start at line 3.
ReadRules readFields(const std::string& fields);

/// Rules for pairs read from text, for one such arm.
struct ReadPairRulesText {
  RobotModel model;
  std::vector<PairRule> rules;
  std::vector<std::string> errors;
  std::vector<std::string> warnings;

  /// The links of one side of a rule.
  std::vector<std::string> names(const std::vector<bool>& side) const;
};

ReadPairRulesText readPairs(const std::string& yaml, IdleRule idle = IdleRule::is_error);

}  // namespace collision_monitor::test
