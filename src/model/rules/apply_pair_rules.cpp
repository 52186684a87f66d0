// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>

#include "collision_monitor/model/pair_rules.h"
#include "geometry/interruption.h"

namespace collision_monitor {
namespace {

/// By kLimitFields: the last rule that sets the field, or kNone.
using FieldRules = decltype(OwnLimits::rules);

/// A mute ignores only what is checked without it.
void decide(const PairRule& rule, std::uint32_t place, LinkPair& pair) {
  const bool is_checked = *rule.is_checked;
  if (rule.ends && !is_checked && !isChecked(pair.reason)) {
    return;
  }
  pair.reason = is_checked  ? PairReason::checked_by_rule
                : rule.ends ? PairReason::muted
                            : PairReason::ignored_by_rule;
  pair.rule = place;
}

FieldRules decideAll(const std::vector<PairRule>& rules, LinkPair& pair) {
  FieldRules fields;
  fields.fill(kNone);
  pair.reason = pair.without_rules;
  pair.rule = kNone;
  for (std::uint32_t i = 0; i < rules.size(); ++i) {
    if (!selects(rules[i], pair.a, pair.b)) {
      continue;
    }
    if (rules[i].is_checked) {
      decide(rules[i], i, pair);
    }
    for (std::size_t field = 0; field < fields.size(); ++field) {
      fields[field] = rules[i].limits[field] ? i : fields[field];
    }
  }
  return fields;
}

OwnLimits ownLimits(const std::vector<PairRule>& rules, const Limits& common,
                    const FieldRules& fields) {
  OwnLimits own{common, fields};
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (fields[i] != kNone) {
      own.limits.*kLimitFields[i].value = *rules[fields[i]].limits[i];
    }
  }
  return own;
}

}  // namespace

bool selects(const PairRule& rule, LinkId a, LinkId b) noexcept {
  return (rule.a[index(a)] && rule.b[index(b)]) || (rule.a[index(b)] && rule.b[index(a)]);
}

std::vector<OwnLimits> applyPairRules(const std::vector<PairRule>& rules, const Limits& common,
                                      std::vector<LinkPair>& pairs) {
  std::vector<OwnLimits> own;
  std::map<FieldRules, std::uint32_t> places;
  for (LinkPair& pair : pairs) {
    throwIfInterrupted();
    const FieldRules fields = decideAll(rules, pair);
    pair.limits = 0;
    if (std::any_of(fields.begin(), fields.end(),
                    [](std::uint32_t rule) { return rule != kNone; })) {
      const auto [place, is_new] =
          places.emplace(fields, static_cast<std::uint32_t>(own.size() + 1));
      if (is_new) {
        own.push_back(ownLimits(rules, common, fields));
      }
      pair.limits = place->second;
    }
  }
  return own;
}

void reportIdleRules(const std::vector<PairRule>& rules, const std::vector<LinkPair>& pairs,
                     IdleRule idle, SetupReport& report) {
  if (idle == IdleRule::is_accepted) {
    return;
  }
  const auto isNone = [](const std::vector<bool>& links) {
    return std::find(links.begin(), links.end(), true) == links.end();
  };
  for (const PairRule& rule : rules) {
    if (idle == IdleRule::is_warning && (isNone(rule.a) || isNone(rule.b))) {
      continue;  // told of its names
    }
    const bool is_idle = std::none_of(pairs.begin(), pairs.end(), [&](const LinkPair& pair) {
      return selects(rule, pair.a, pair.b);
    });
    if (is_idle) {
      const std::string found = "a rule that selects no pair";
      const std::string accepted =
          "two links with shapes, one of 'a' and one of 'b', or a link and an object; or two "
          "objects if one is attached, or if the rule says check: true, names no links, and their "
          "frames differ";
      idle == IdleRule::is_error
          ? report.errors.push_back({rule.where, found, accepted})
          : report.warnings.push_back({rule.where, found, "", "it needs " + accepted});
    }
  }
}

}  // namespace collision_monitor
