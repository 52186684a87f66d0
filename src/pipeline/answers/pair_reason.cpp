// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/answers/pair_reason.h"

#include <algorithm>
#include <tuple>

#include "model/rules/rigid_groups.h"

namespace collision_monitor {
namespace {

/// " (robot.srdf line 12, Never)" for the first of these lines that names the pair; else nothing.
std::string lineOf(const std::string& source, const std::vector<SrdfPairs::Entry>& entries,
                   const LinkPair& pair) {
  for (const SrdfPairs::Entry& entry : entries) {
    if ((entry.a == pair.a && entry.b == pair.b) || (entry.a == pair.b && entry.b == pair.a)) {
      return " (" + source + " line " + std::to_string(entry.line) +
             (entry.reason.empty() ? "" : ", " + entry.reason) + ")";
    }
  }
  return "";
}

std::string srdfPlace(const CycleSetup& setup, const LinkPair& pair) {
  const bool is_enabled = pair.reason == PairReason::enabled_by_srdf;
  for (const SrdfPairs& srdf : setup.srdfs) {
    std::string line = lineOf(srdf.source, is_enabled ? srdf.enabled : srdf.disabled, pair);
    if (!line.empty()) {
      return line;
    }
    for (const SrdfPairs::Default& entry : srdf.disabled_by_default) {
      if (!is_enabled && (entry.link == pair.a || entry.link == pair.b)) {
        return " (" + srdf.source + " line " + std::to_string(entry.line) +
               ", disable_default_collisions of " + setup.model.link(entry.link).name + ")";
      }
    }
  }
  return "";
}

}  // namespace

std::size_t findLinkPair(const CycleSetup& setup, LinkId a, LinkId b) noexcept {
  const std::pair<LinkId, LinkId> wanted = std::minmax(a, b);
  const auto place =
      std::lower_bound(setup.link_pairs.begin(), setup.link_pairs.end(), wanted,
                       [](const LinkPair& pair, const std::pair<LinkId, LinkId>& key) {
                         return std::tie(pair.a, pair.b) < std::tie(key.first, key.second);
                       });
  const bool is_found =
      place != setup.link_pairs.end() && place->a == wanted.first && place->b == wanted.second;
  return is_found ? static_cast<std::size_t>(place - setup.link_pairs.begin())
                  : setup.link_pairs.size();
}

std::string reasonOf(const CycleSetup& setup, const LinkPair& pair) {
  std::string reason = reasonText(pair.reason);
  if (pair.rule != kNone) {
    return reason + " (" + setup.pair_rules[pair.rule].where + ")";
  }
  if (pair.reason == PairReason::enabled_by_srdf || pair.reason == PairReason::disabled_by_srdf) {
    return reason + srdfPlace(setup, pair);
  }
  return reason;
}

std::string reasonOfObjects(const std::vector<LinkId>& groups, LinkId a, LinkId b) {
  return groups[index(a)] == groups[index(b)]
             ? "ignored: two objects that move together"
             : "ignored: two objects of which neither is attached, and for which no rule asks";
}

std::vector<std::string> limitPlaces(const CycleSetup& setup, const LinkPair& pair) {
  std::vector<std::string> places(kLimitFields.size());
  for (std::size_t i = 0; pair.limits != 0 && i < places.size(); ++i) {
    const std::uint32_t rule = setup.own_limits[pair.limits - 1].rules[i];
    places[i] = rule == kNone ? "" : setup.pair_rules[rule].where;
  }
  return places;
}

const Limits& limitsOf(const CycleSetup& setup, const LinkPair& pair) noexcept {
  return limitsOf(setup, CheckedLinkPair{pair.a, pair.b, pair.limits});
}

}  // namespace collision_monitor
