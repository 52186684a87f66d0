// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/outputs/pair_counts.h"

#include <cmath>
#include <tuple>

namespace collision_monitor {

static_assert(static_cast<std::size_t>(PairReason::two_objects) + 1 ==
              std::tuple_size_v<PairCounts>);

PairCounts countPairs(const std::vector<LinkPair>& pairs) {
  PairCounts counts{};
  for (const LinkPair& pair : pairs) {
    ++counts[static_cast<std::size_t>(pair.reason)];
  }
  return counts;
}

std::size_t countOf(PairReason reason, const PairCounts& counts) {
  return counts[static_cast<std::size_t>(reason)];
}

const char* whyNotText(PairReason reason) noexcept {
  switch (reason) {
    case PairReason::same_rigid_group:
      return "joined by fixed joints only";
    case PairReason::adjacent:
      return "that meet at a joint";
    case PairReason::disabled_by_srdf:
      return "disabled by the SRDF";
    case PairReason::default_overlap:
      return "that overlap in the default pose";
    case PairReason::ignored_by_user:
      return "hidden by ignore_pairs";
    case PairReason::ignored_by_rule:
      return "ignored by pair_rules";
    case PairReason::muted:
      return "muted";
    case PairReason::touch_link:
      return "of objects and links that may touch them";
    case PairReason::two_objects:
      return "of two objects";
    case PairReason::checked:
    case PairReason::checked_by_rule:
    case PairReason::enabled_by_srdf:
      return "checked";
  }
  return "";
}

std::string muteText(std::size_t pairs, double time) {
  if (pairs == 0) {
    return "";
  }
  const std::string muted = "; " + std::to_string(pairs) +
                            (pairs == 1 ? " pair of links is" : " pairs of links are") + " muted";
  return time > 0.0 ? muted + " for another " + std::to_string(std::lround(std::ceil(time))) + " s"
                    : muted + " until a change that is being made is done";
}

std::string notCheckedText(const PairCounts& counts) {
  std::string text;
  for (const PairReason reason : kReasonsNotToCheck) {
    if (const std::size_t count = countOf(reason, counts); count > 0) {
      text += (text.empty() ? "; not checked: " : ", ") + std::to_string(count) + " " +
              whyNotText(reason);
    }
  }
  return text;
}

}  // namespace collision_monitor
