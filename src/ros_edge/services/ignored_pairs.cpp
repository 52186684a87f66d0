// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/services/ignored_pairs.h"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <tuple>
#include <unordered_map>

#include "collision_monitor/geometry/ids.h"
#include "model/few_texts.h"
#include "model/object_links.h"
#include "model/place.h"
#include "model/rules/rigid_groups.h"
#include "pipeline/answers/pair_reason.h"
#include "ros_edge/outputs/sentences.h"

namespace collision_monitor {
namespace {

std::vector<LinkId> objectsIn(const LinkSet& links, const RobotModel& model) {
  std::vector<LinkId> objects;
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (links[i] != 0 && isObject(model, idAt<LinkId>(i))) {
      objects.push_back(idAt<LinkId>(i));
    }
  }
  return objects;
}

/// Adds the pairs of two objects that the set-up does not know, since they may be too many.
/// @return a fault if they are; nothing is added then
std::string addObjectPairs(const CycleSetup& setup, const Selection& selection,
                           std::vector<LinkPair>& pairs) {
  constexpr std::size_t kMost = 100'000;
  const std::vector<LinkId> first = objectsIn(selection.a, setup.model);
  const std::vector<LinkId> second = objectsIn(selection.b, setup.model);
  if (first.size() * second.size() > kMost) {
    return "include_ignored asks for " + std::to_string(first.size()) + " x " +
           std::to_string(second.size()) + " pairs of two objects; accepted: at most " +
           std::to_string(kMost) + ", so name links in links_a or links_b";
  }
  for (const LinkId a : first) {
    for (const LinkId b : second) {
      const bool is_second = b < a && selection.a[index(b)] != 0 && selection.b[index(a)] != 0;
      if (a != b && !is_second && findLinkPair(setup, a, b) == setup.link_pairs.size()) {
        LinkPair& pair = pairs.emplace_back();
        std::tie(pair.a, pair.b) = std::minmax(a, b);
      }
    }
  }
  return "";
}

}  // namespace

std::string ignoredText(const CycleSetup& setup, const Selection& selection) {
  FewTexts found;
  for (const LinkPair& pair : setup.link_pairs) {
    if (!isChecked(pair.reason) && selection.has(pair.a, pair.b)) {
      found.add([&] {
        return nameInText(setup.model, pair.a) + " and " + nameInText(setup.model, pair.b) + " (" +
               reasonText(pair.reason) + ")";
      });
    }
  }
  const std::vector<std::string> ignored = found.all();
  return ignored.empty() ? "" : "not checked: " + join(ignored);
}

std::vector<LinkPair> pairsOf(const CycleSetup& setup, const Selection& selection,
                              std::string& fault) {
  std::vector<LinkPair> pairs;
  std::copy_if(setup.link_pairs.begin(), setup.link_pairs.end(), std::back_inserter(pairs),
               [&](const LinkPair& pair) { return selection.has(pair.a, pair.b); });
  fault = addObjectPairs(setup, selection, pairs);
  return pairs;
}

std::vector<std::string> reasonsOf(const CycleSetup& setup,
                                   const std::vector<LinkDistance>& pairs) {
  const std::vector<LinkId> groups = findRigidGroups(setup.model);
  std::unordered_map<std::string_view, LinkId> ids;
  for (std::size_t i = 0; i < setup.model.links.size(); ++i) {
    if (hasShapes(setup.model.links[i])) {  // a frame that carries objects may have a link's name
      ids.emplace(setup.model.links[i].name, idAt<LinkId>(i));
    }
  }
  std::vector<std::string> reasons;
  for (const LinkDistance& pair : pairs) {
    const LinkId a = ids.at(pair.link_a);
    const LinkId b = ids.at(pair.link_b);
    const std::size_t place = findLinkPair(setup, a, b);
    reasons.push_back(place < setup.link_pairs.size() ? reasonOf(setup, setup.link_pairs[place])
                                                      : reasonOfObjects(groups, a, b));
  }
  return reasons;
}

}  // namespace collision_monitor
