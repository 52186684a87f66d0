// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/services/change_rules.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_set>
#include <utility>

#include "model/nearest_name.h"
#include "model/number_text.h"
#include "model/place.h"
#include "ros_edge/outputs/pair_counts.h"
#include "ros_edge/outputs/sentences.h"

namespace collision_monitor {
namespace {

constexpr double kLongestRules = 86400.0;  // [s]

/// Rules, and when each ends.
struct TimedRules {
  std::vector<PairRule> rules;
  std::vector<RuleEnd> ends;

  void add(const PairRule& rule, RuleEnd end) {
    rules.push_back(rule);
    rules.back().ends = end != kLasts;
    ends.push_back(end);
  }
};

template <class IsKept>
TimedRules keepRules(const MonitorSetup& current, const IsKept& is_kept) {
  TimedRules kept;
  for (std::size_t i = 0; i < current.rule_ends.size(); ++i) {
    if (is_kept(current.rule_ends[i])) {
      kept.add(current.setup.pair_rules[i], current.rule_ends[i]);
    }
  }
  return kept;
}

/// Checks the set-ups that will follow as rules end: an end must not fail. Rules without limits
/// cannot make it fail, and there may be hundreds of mutes.
void checkEnds(const MonitorSetup& current, const Limits& limits, const TimedRules& rules,
               SetupReport& report) {
  TimedRules limiting;
  for (std::size_t i = 0; i < rules.rules.size(); ++i) {
    const LimitChanges& changes = rules.rules[i].limits;
    if (std::any_of(changes.begin(), changes.end(),
                    [](const auto& one) { return one.has_value(); })) {
      limiting.add(rules.rules[i], rules.ends[i]);
    }
  }
  for (const RuleEnd end : std::set<RuleEnd>(limiting.ends.begin(), limiting.ends.end())) {
    std::vector<PairRule> left;
    for (std::size_t i = 0; i < limiting.rules.size(); ++i) {
      if (limiting.ends[i] > end) {
        left.push_back(limiting.rules[i]);
      }
    }
    if (end != kLasts) {
      checkPairRules(current.setup, limits, left, report);
    }
  }
}

/// @throws SetupError
std::shared_ptr<MonitorSetup> makeChanged(const MonitorSetup& current, const Limits& limits,
                                          const TimedRules& rules, SetupReport& report) {
  checkEnds(current, limits, rules, report);
  throwIfErrors(report);
  std::shared_ptr<MonitorSetup> changed = partsOf(current);
  changed->setup = withPairRules(current.setup, limits, rules.rules, report);
  changed->rule_ends = rules.ends;
  return changed;
}

/// Takes the limits away from rules whose limits do not fit to those of the rules before.
/// @return a warning for each of these rules
std::vector<Problem> dropMisfits(const MonitorSetup& current, TimedRules& rules) {
  std::vector<LimitChanges> wanted;
  for (PairRule& rule : rules.rules) {
    wanted.push_back(std::exchange(rule.limits, {}));
  }
  std::vector<Problem> dropped;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    rules.rules[i].limits = wanted[i];
    SetupReport report;
    checkEnds(current, current.setup.limits, rules, report);
    checkPairRules(current.setup, current.setup.limits, rules.rules, report);
    if (!report.errors.empty()) {
      rules.rules[i].limits = {};
      dropped.push_back({rules.rules[i].where, "limits that do not fit to others any more", "",
                         "its limits are dropped: " + toString(report.errors.front())});
    }
  }
  return dropped;
}

std::string textOf(const std::vector<Problem>& problems) {
  constexpr std::size_t kShown = 50;  // a request may have a million faults
  std::vector<std::string> texts;
  std::unordered_set<std::string> known;
  for (const Problem& problem : problems) {
    std::string text = toString(problem);
    if (known.insert(text).second && known.size() <= kShown) {
      texts.push_back(std::move(text));
    }
  }
  if (known.size() > kShown) {
    texts.push_back("and " + std::to_string(known.size() - kShown) + " more");
  }
  return join(texts);
}

std::string refusalOf(const std::vector<Problem>& problems) {
  return "nothing was changed: " + textOf(problems);
}

/// When the rules of a request end. @param duration [s] checked; 0: they last
RuleEnd endOf(RuleEnd now, double duration) {
  return duration > 0.0 ? now + std::chrono::duration_cast<RuleEnd::duration>(
                                    std::chrono::duration<double>(duration))
                        : kLasts;
}

/// The rules of a request after those that stay.
/// @param duration [s] checked
TimedRules mergeRules(const MonitorSetup& current, RuleEnd now, std::size_t number,
                      const SetPairs::Request& request, SetupReport& report) {
  const bool ends = request.duration > 0.0;
  const bool replaces = request.action == SetPairs::Request::REPLACE;
  TimedRules merged = keepRules(
      current, [&](RuleEnd end) { return end > now && (!replaces || (ends && end == kLasts)); });
  const DocumentText text{"set_pairs request " + std::to_string(number), request.rules};
  const RuleEnd end = endOf(now, request.duration);
  for (const PairRule& rule : readPairRules(text, current.setup.model, current.setup.srdfs,
                                            IdleRule::is_warning, report)) {
    merged.add(rule, end);
  }
  return merged;
}

void checkRequest(const SetPairs::Request& request, SetupReport& report) {
  if (request.action > SetPairs::Request::APPEND) {
    report.errors.push_back(
        {"action", std::to_string(request.action), "REPLACE (0) or APPEND (1)"});
  }
  if (!(request.duration >= 0.0 && request.duration <= kLongestRules)) {
    report.errors.push_back({"duration", shortText(request.duration) + " s",
                             "from 0 s to " + shortText(kLongestRules) + " s"});
  }
}

/// "; 2 of them end in 12.500 s"; nothing if none of the new rules ends.
std::string endText(const std::vector<RuleEnd>& ends, RuleEnd now, double duration) {
  const auto count = std::count(ends.begin(), ends.end(), endOf(now, duration));
  return duration == 0.0 || count == 0
             ? ""
             : "; " + std::to_string(count) + " of them end" + (count == 1 ? "s" : "") + " in " +
                   secondsText(duration);
}

std::string changedText(const MonitorSetup& changed) {
  const PairCounts counts = countPairs(changed.setup.link_pairs);
  return counted(changed.setup.pair_rules.size(), "rule") +
         "; checked: " + counted(changed.setup.checked.size(), "pair") + " of links" +
         notCheckedText(counts);
}

/// The place of a limit in kLimitFields; its end if there is none.
std::size_t fieldNamed(const std::string& name) {
  const auto field = std::find_if(kLimitFields.begin(), kLimitFields.end(),
                                  [&](const LimitField& one) { return name == one.name; });
  return static_cast<std::size_t>(field - kLimitFields.begin());
}

LimitChanges readChanges(const SetLimits::Request& request, SetupReport& report) {
  LimitChanges changes{};
  std::vector<std::string> known;
  known.reserve(kLimitFields.size());
  for (const LimitField& field : kLimitFields) {
    known.emplace_back(field.name);
  }
  if (request.names.empty() || request.names.size() != request.values.size()) {
    report.errors.push_back(
        {"names",
         counted(request.names.size(), "name") + " and " + counted(request.values.size(), "value"),
         "one value for each name, and one name at least"});
    return changes;
  }
  for (std::size_t i = 0; i < request.names.size(); ++i) {
    const std::string& name = request.names[i];
    const std::size_t place = fieldNamed(name);
    if (place == kLimitFields.size()) {
      report.errors.push_back(
          {"names", quoted(name) + ", which is no limit" + suggestion(name, known), joined(known)});
      continue;
    }
    const LimitField& field = kLimitFields[place];
    if (changes[place]) {
      report.errors.push_back({name, "a second time", "each limit once"});
    } else if (!(request.values[i] >= field.least && request.values[i] <= field.greatest)) {
      report.errors.push_back({name, shortText(request.values[i]) + field.unit,
                               "from " + shortText(field.least) + field.unit + " to " +
                                   shortText(field.greatest) + field.unit});
    }
    changes[place] = request.values[i];
  }
  return changes;
}

}  // namespace

NextSetup answerSetPairs(const MonitorSetup& current, RuleEnd now, std::size_t number,
                         const SetPairs::Request& request, SetPairs::Response& response) {
  response.success = 0;
  SetupReport report;
  try {
    checkRequest(request, report);
    throwIfErrors(report);
    const TimedRules merged = mergeRules(current, now, number, request, report);
    throwIfErrors(report);
    std::shared_ptr<MonitorSetup> changed =
        makeChanged(current, current.setup.limits, merged, report);
    response.success = 1;
    response.message = changedText(*changed) + endText(merged.ends, now, request.duration) +
                       (report.warnings.empty() ? "" : "; " + textOf(report.warnings));
    response.pairs_checked = static_cast<std::uint32_t>(changed->setup.checked.size());
    response.pairs_muted = static_cast<std::uint32_t>(
        countOf(PairReason::muted, countPairs(changed->setup.link_pairs)));
    return changed;
  } catch (const SetupError& error) {
    response.message = refusalOf(error.problems());
  } catch (const std::exception& error) {
    response.message = "nothing was changed: " + failureText(error);
  }
  return nullptr;
}

NextSetup answerSetLimits(const MonitorSetup& current, const SetLimits::Request& request,
                          SetLimits::Response& response) {
  response.success = 0;
  SetupReport report;
  try {
    const LimitChanges changes = readChanges(request, report);
    throwIfErrors(report);
    Limits limits = current.setup.limits;
    change(changes, limits);
    const TimedRules rules = keepRules(current, [](RuleEnd) { return true; });
    std::shared_ptr<MonitorSetup> changed = makeChanged(current, limits, rules, report);
    response.success = 1;
    for (const LimitField& field : kLimitFields) {
      response.message += (response.message.empty() ? "" : ", ") + std::string(field.name) + " " +
                          shortText(limits.*field.value) + field.unit;
    }
    return changed;
  } catch (const SetupError& error) {
    response.message = refusalOf(error.problems());
  } catch (const std::exception& error) {
    response.message = "nothing was changed: " + failureText(error);
  }
  return nullptr;
}

NextSetup withoutEnded(const MonitorSetup& current, RuleEnd now,
                       std::vector<Problem>& dropped_limits) {
  if (nextEndOf(current) > now) {
    return nullptr;
  }
  SetupReport ignored;
  TimedRules left = keepRules(current, [&](RuleEnd end) { return end > now; });
  try {
    return makeChanged(current, current.setup.limits, left, ignored);
  } catch (const SetupError&) {
    // With objects that came later, limits that are left need not fit together. No mute may last.
    dropped_limits = dropMisfits(current, left);
    return makeChanged(current, current.setup.limits, left, ignored = SetupReport());
  }
}

RuleEnd nextEndOf(const MonitorSetup& current) {
  const auto next = std::min_element(current.rule_ends.begin(), current.rule_ends.end());
  return next == current.rule_ends.end() ? kLasts : *next;
}

}  // namespace collision_monitor
