// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>
#include <tuple>

#include "geometry/interruption.h"
#include "model/object_links.h"
#include "model/rules/rigid_groups.h"
#include "setup_parts.h"

namespace collision_monitor {
namespace {

bool comesBefore(const LinkPair& one, const LinkPair& other) noexcept {
  return std::tie(one.a, one.b) < std::tie(other.a, other.b);
}

bool isSamePair(const LinkPair& one, const LinkPair& other) noexcept {
  return std::tie(one.a, one.b) == std::tie(other.a, other.b);
}

/// The objects that one side of a rule selects; none if it selects other links, too.
std::vector<LinkId> onlyObjects(const std::vector<bool>& side, const RobotModel& model) {
  std::vector<LinkId> objects;
  for (std::size_t i = 0; i < side.size(); ++i) {
    const auto link = idAt<LinkId>(i);
    if (side[i] && hasShapes(model.link(link))) {
      if (!isObject(model, link)) {
        return {};
      }
      objects.push_back(link);
    }
  }
  return objects;
}

/// Adds the pairs that a rule asks for.
void addAsked(const PairRule& rule, const RobotModel& model, const std::vector<LinkId>& group_of,
              SetupReport& report, std::vector<LinkPair>& asked) {
  constexpr std::size_t kMost = 1'000'000;
  const std::vector<LinkId> first = onlyObjects(rule.a, model);
  const std::vector<LinkId> second = onlyObjects(rule.b, model);
  if (first.size() * second.size() > kMost) {
    report.errors.push_back({rule.where,
                             std::to_string(first.size()) + " objects and " +
                                 std::to_string(second.size()) + " objects to check",
                             "at most " + std::to_string(kMost) + " pairs of two objects"});
    return;
  }
  for (const LinkId a : first) {
    throwIfInterrupted();
    for (const LinkId b : second) {
      if (group_of[index(a)] != group_of[index(b)]) {
        LinkPair& pair = asked.emplace_back();
        std::tie(pair.a, pair.b) = std::minmax(a, b);
        pair.reason = pair.without_rules = PairReason::two_objects;
      }
    }
  }
}

}  // namespace

std::vector<LinkPair> withAskedPairs(const CycleSetup& setup, const std::vector<PairRule>& rules,
                                     SetupReport& report) {
  std::vector<LinkPair> pairs = setup.link_pairs;
  if (!hasObjects(setup.model)) {
    return pairs;
  }
  pairs.erase(std::remove_if(pairs.begin(), pairs.end(),
                             [](const LinkPair& pair) {
                               return pair.without_rules == PairReason::two_objects;
                             }),
              pairs.end());
  std::vector<LinkPair> asked;
  const std::vector<LinkId> group_of = findRigidGroups(setup.model);
  for (const PairRule& rule : rules) {
    if (rule.is_checked.value_or(false)) {
      addAsked(rule, setup.model, group_of, report, asked);
    }
  }
  // Pairs with an attached object are there without being asked for; these come first.
  const auto middle = static_cast<std::ptrdiff_t>(pairs.size());
  std::stable_sort(asked.begin(), asked.end(), comesBefore);
  pairs.insert(pairs.end(), asked.begin(), asked.end());
  std::inplace_merge(pairs.begin(), pairs.begin() + middle, pairs.end(), comesBefore);
  pairs.erase(std::unique(pairs.begin(), pairs.end(), isSamePair), pairs.end());
  return pairs;
}

}  // namespace collision_monitor
