// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "check_srdf.h"

#include <algorithm>

#include "collision_monitor/model/srdf_reader.h"
#include "report.h"
#include "srdf_places.h"

namespace collision_monitor::pairs_tool {
namespace {

std::string namesOf(const RobotModel& model, const PairFound& pair) {
  return "'" + model.link(pair.a).name + "' - '" + model.link(pair.b).name + "'";
}

/// " (line 12, Never)"; empty for pairs that disable_default_collisions leaves out.
std::string lineText(const SrdfPlaces& places, const std::string& a, const std::string& b) {
  for (const SrdfLine& line : places.disabled) {
    if ((line.link1 == a && line.link2 == b) || (line.link1 == b && line.link2 == a)) {
      return " (line " + std::to_string(line.number) +
             (line.reason.empty() ? "" : ", " + line.reason) + ")";
    }
  }
  return "";
}

void checkPair(const RobotModel& model, const PairFound& pair, bool is_disabled,
               const std::string& line, SrdfCheck& check) {
  const std::string names = namesOf(model, pair);
  if (is_disabled && pair.finding == PairFinding::sometimes) {
    check.touching.push_back(names + line + " touch " + stateText(model, pair));
  } else if (is_disabled && pair.finding == PairFinding::unclear) {
    check.unclear.push_back(names + line + " may touch " + stateText(model, pair));
  } else if (!is_disabled && pair.is_proven) {
    check.needless.push_back(
        names + (pair.finding == PairFinding::never ? " never touch" : " always touch"));
  }
}

std::string listOf(const std::string& heading, const std::vector<std::string>& items) {
  std::string text = items.empty() ? "" : std::to_string(items.size()) + " " + heading + ":\n";
  for (const std::string& item : items) {
    text += "  " + item + "\n";
  }
  return text;
}

}  // namespace

SrdfCheck checkSrdf(const RobotDescription& description, const RobotModel& model,
                    const std::vector<PairFound>& pairs, SetupReport& report) {
  const SrdfPairs srdf = readSrdf(description, RobotId{0}, model, report);
  SrdfCheck check;
  if (!report.errors.empty()) {
    return check;
  }
  const SrdfPlaces places = findPlaces(description.srdf_xml);
  const std::vector<LinkPair> decided = decideLinkPairs(model, {srdf});
  for (const PairFound& pair : pairs) {
    const auto rule = std::find_if(decided.begin(), decided.end(), [&](const LinkPair& links) {
      return links.a == pair.a && links.b == pair.b;
    });
    if (rule == decided.end() || pair.finding == PairFinding::adjacent) {
      continue;
    }
    const bool is_disabled = rule->reason == PairReason::disabled_by_srdf;
    if (is_disabled || isChecked(rule->reason)) {
      checkPair(model, pair, is_disabled,
                lineText(places, model.link(pair.a).name, model.link(pair.b).name), check);
    }
  }
  return check;
}

std::string textOf(const SrdfCheck& check) {
  const std::string text =
      listOf("pairs are disabled although they touch", check.touching) +
      listOf("pairs are disabled although what encloses them touches", check.unclear) +
      listOf("pairs are checked although a proof makes that needless", check.needless);
  return text.empty() ? "the SRDF disables no pair that touches, and checks none in vain\n" : text;
}

}  // namespace collision_monitor::pairs_tool
