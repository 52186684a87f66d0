// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/link_selection.h"

#include "model/frame_names.h"

namespace collision_monitor {
namespace {

/// The first of the names; there may be hundreds.
std::string someOf(std::vector<std::string> names, const char* none) {
  constexpr std::size_t kShown = 12;
  if (names.size() > kShown) {
    const std::size_t left_out = names.size() - kShown;
    names.resize(kShown);
    names.push_back(std::to_string(left_out) + " more");
  }
  return names.empty() ? none : joined(names);
}

}  // namespace

bool matches(const std::string& pattern, const std::string& name) {
  // On a mismatch the last star takes one character more: no recursion, and at worst
  // pattern times name steps.
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
    for (const LinkGroup& group : srdf.groups) {
      const std::string& prefix = model.robots[index(srdf.robot)].tf_prefix;
      if (group.name == name || prefixed(trimmedPrefix(prefix), group.name) == name) {
        is_found = true;
        links.insert(links.end(), group.links.begin(), group.links.end());
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
  return someOf(names, "none: no SRDF has groups");
}

std::string linkNames(const RobotModel& model) {
  std::vector<std::string> names;
  for (const Link& link : model.links) {
    names.push_back(quoted(link.name));
  }
  return someOf(names, "none");
}

}  // namespace collision_monitor
