// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/rules/link_selection.h"

#include "model/frame_names.h"

namespace collision_monitor {
bool matches(const std::string& pattern, const std::string& name) {
  // On a mismatch the last star takes one more character. This needs no recursion and at most
  // pattern length times name length comparisons.
  std::size_t p = 0;
  std::size_t n = 0;
  std::size_t star = std::string::npos;
  std::size_t taken_to = 0;
  while (n < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      taken_to = n;
    } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == name[n])) {
      ++p;
      ++n;
    } else if (star != std::string::npos) {
      p = star + 1;
      n = ++taken_to;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string::npos;
}

std::string urdfNameOf(const RobotModel& model, LinkId link) {
  const Link& named = model.link(link);
  const std::string front = trimmedPrefix(model.robots[index(named.robot)].tf_prefix) + "/";
  return front.size() > 1 && named.name.compare(0, front.size(), front) == 0
             ? named.name.substr(front.size())
             : named.name;
}

std::vector<LinkId> findMatching(const std::string& pattern, const RobotModel& model) {
  std::vector<LinkId> links;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const LinkId link = idAt<LinkId>(i);
    if (matches(pattern, model.links[i].name) || matches(pattern, urdfNameOf(model, link))) {
      links.push_back(link);
    }
  }
  return links;
}

std::optional<std::vector<LinkId>> findGroup(const std::string& name, const RobotModel& model,
                                             const std::vector<SrdfPairs>& srdfs) {
  std::vector<LinkId> links;
  bool is_found = false;
  for (const SrdfPairs& srdf : srdfs) {
    const std::string prefix = trimmedPrefix(model.robots[index(srdf.robot)].tf_prefix);
    for (std::size_t i = 0; i < srdf.groups.size(); ++i) {
      const std::string& own = srdf.groups[i].name;
      if (own == name || prefixed(prefix, own) == name) {
        is_found = true;
        const std::vector<LinkId> held = linksOf(srdf.groups, i, model);
        links.insert(links.end(), held.begin(), held.end());
      }
    }
  }
  return is_found ? std::optional<std::vector<LinkId>>(links) : std::nullopt;
}

std::string groupNames(const std::vector<SrdfPairs>& srdfs) {
  std::vector<std::string> names;
  for (const SrdfPairs& srdf : srdfs) {
    for (const LinkGroup& group : srdf.groups) {
      names.push_back(quoted(group.name));
    }
  }
  return names.empty() ? "none: no SRDF or object has groups" : someOf(names);
}

std::string linkNames(const RobotModel& model) {
  std::vector<std::string> names;
  for (const Link& link : model.links) {
    names.push_back(quoted(link.name));
  }
  return names.empty() ? "none" : someOf(names);
}

}  // namespace collision_monitor
