// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/model/pair_rules.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "geometry/interruption.h"
#include "model/place.h"
#include "model/rules/link_selection.h"
#include "model/rules/rigid_groups.h"

namespace collision_monitor {

/// Parents come before children.
std::vector<LinkId> findRigidGroups(const RobotModel& model) {
  std::vector<LinkId> group_of(model.links.size());
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const auto& joint = model.links[i].parent_joint;
    const bool is_fixed = joint && model.joint(*joint).type == JointType::fixed;
    group_of[i] = is_fixed ? group_of[index(model.joint(*joint).parent)] : idAt<LinkId>(i);
  }
  return group_of;
}

namespace {

LinkIdPair ordered(LinkId a, LinkId b) { return a < b ? LinkIdPair(a, b) : LinkIdPair(b, a); }

std::optional<LinkId> parentOf(const RobotModel& model, LinkId link) {
  const auto& joint = model.link(link).parent_joint;
  return joint ? std::optional<LinkId>(model.joint(*joint).parent) : std::nullopt;
}

std::set<LinkIdPair> findAdjacent(const RobotModel& model) {
  std::set<LinkIdPair> adjacent;
  std::vector<std::optional<LinkId>> ancestor_of(model.links.size());  // the nearest with shapes
  for (std::size_t i = 0; i < model.links.size(); ++i) {  // parents come before children
    const LinkId link = idAt<LinkId>(i);
    const std::optional<LinkId> parent = parentOf(model, link);
    if (parent) {
      ancestor_of[i] = hasShapes(model.link(*parent)) ? parent : ancestor_of[index(*parent)];
    }
    if (ancestor_of[i]) {
      adjacent.insert(ordered(*ancestor_of[i], link));
    }
  }
  return adjacent;
}

/// All rules, prepared for queries about single pairs.
struct Rules {
  std::set<LinkIdPair> ignored;
  std::vector<LinkId> group_of;
  std::set<LinkIdPair> adjacent;
  std::set<LinkIdPair> enabled;
  std::set<LinkIdPair> disabled;
  std::vector<bool> is_disabled_by_default;  ///< by link
};

Rules gatherRules(const RobotModel& model, const std::vector<SrdfPairs>& srdfs,
                  const std::vector<LinkIdPair>& ignored) {
  Rules rules;
  rules.ignored.insert(ignored.begin(), ignored.end());
  rules.group_of = findRigidGroups(model);
  rules.adjacent = findAdjacent(model);
  rules.is_disabled_by_default.assign(model.links.size(), false);
  for (const SrdfPairs& srdf : srdfs) {
    for (const SrdfPairs::Entry& entry : srdf.enabled) {
      rules.enabled.insert(ordered(entry.a, entry.b));
    }
    for (const SrdfPairs::Entry& entry : srdf.disabled) {
      rules.disabled.insert(ordered(entry.a, entry.b));
    }
    for (const SrdfPairs::Default& entry : srdf.disabled_by_default) {
      rules.is_disabled_by_default[index(entry.link)] = true;
    }
  }
  return rules;
}

PairReason decide(const RobotModel& model, const Rules& rules, LinkId a, LinkId b) {
  if (rules.ignored.count({a, b}) != 0) {
    return PairReason::ignored_by_user;
  }
  if (model.link(a).robot != model.link(b).robot) {
    return PairReason::checked;
  }
  if (rules.group_of[index(a)] == rules.group_of[index(b)]) {
    return PairReason::same_rigid_group;
  }
  const LinkIdPair pair(a, b);
  if (rules.enabled.count(pair) != 0) {
    return PairReason::enabled_by_srdf;
  }
  if (rules.disabled.count(pair) != 0 || rules.is_disabled_by_default[index(a)] ||
      rules.is_disabled_by_default[index(b)]) {
    return PairReason::disabled_by_srdf;
  }
  return rules.adjacent.count(pair) != 0 ? PairReason::adjacent : PairReason::checked;
}

std::vector<LinkId> findNamed(const std::string& name, const std::string& where,
                              const RobotModel& model, SetupReport& report) {
  std::vector<LinkId> links = findMatching(name, model);
  if (links.empty() && !report.awaits_names) {
    report.errors.push_back({where, "link " + quoted(name) + ", which matches none",
                             "links of the robots: " + linkNames(model)});
  }
  return links;
}

}  // namespace

std::vector<LinkIdPair> findNamedPairs(const std::vector<NamedPair>& named, const std::string& list,
                                       const RobotModel& model, SetupReport& report) {
  std::vector<LinkIdPair> pairs;
  for (std::size_t i = 0; i < named.size(); ++i) {
    const std::string where = list + "[" + std::to_string(i) + "]";
    const std::vector<LinkId> first = findNamed(named[i].a, where, model, report);
    const std::vector<LinkId> second = findNamed(named[i].b, where, model, report);
    const std::size_t before = pairs.size();
    for (const LinkId a : first) {
      for (const LinkId b : second) {
        if (a != b) {
          pairs.push_back(ordered(a, b));
        }
      }
    }
    if (pairs.size() == before && !first.empty() && !second.empty()) {
      report.errors.push_back(
          {where, quoted(named[i].a) + " twice", "the names of two different links"});
    }
  }
  return pairs;
}

const char* reasonText(PairReason reason) noexcept {
  switch (reason) {
    case PairReason::checked:
      return "checked: no rule says otherwise";
    case PairReason::enabled_by_srdf:
      return "checked: an enable_collisions line of the SRDF";
    case PairReason::same_rigid_group:
      return "ignored: only fixed joints between the links";
    case PairReason::adjacent:
      return "ignored: the links meet at a joint";
    case PairReason::disabled_by_srdf:
      return "ignored: a line of the SRDF";
    case PairReason::default_overlap:
      return "ignored: the links overlap in the default pose and there is no SRDF";
    case PairReason::ignored_by_user:
      return "ignored: parameter ignore_pairs";
    case PairReason::checked_by_rule:
      return "checked: a rule for pairs";
    case PairReason::ignored_by_rule:
      return "ignored: a rule for pairs";
    case PairReason::muted:
      return "muted: a rule for pairs that ends by itself";
    case PairReason::touch_link:
      return "ignored: an object and a link that may touch it";
    case PairReason::two_objects:
      return "ignored: two objects of which neither is attached";
  }
  return "unknown reason";
}

bool isChecked(PairReason reason) noexcept {
  return reason == PairReason::checked || reason == PairReason::enabled_by_srdf ||
         reason == PairReason::checked_by_rule;
}

std::vector<LinkPair> decideLinkPairs(const RobotModel& model, const std::vector<SrdfPairs>& srdfs,
                                      const std::vector<LinkIdPair>& ignored) {
  const Rules rules = gatherRules(model, srdfs, ignored);
  std::vector<LinkId> with_shapes;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    if (hasShapes(model.links[i])) {
      with_shapes.push_back(idAt<LinkId>(i));
    }
  }
  std::vector<LinkPair> pairs;
  pairs.reserve(with_shapes.size() * (with_shapes.size() - 1) / 2);
  for (std::size_t i = 0; i < with_shapes.size(); ++i) {
    throwIfInterrupted();
    for (std::size_t j = i + 1; j < with_shapes.size(); ++j) {
      const LinkId a = with_shapes[i];
      const LinkId b = with_shapes[j];
      const PairReason reason = decide(model, rules, a, b);
      pairs.push_back({a, b, reason, reason});
    }
  }
  return pairs;
}

}  // namespace collision_monitor
