// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/publisher_names.h"

#include "model/place.h"

namespace collision_monitor {

PublisherId PublisherNames::idOf(const std::string& name) {
  constexpr std::size_t kMost = 1000;
  if (name.empty()) {
    return {};
  }
  const auto known = ids_.find(name);
  if (known != ids_.end()) {
    return known->second;
  }
  if (names_.size() > kMost) {
    return {};
  }
  const auto id = static_cast<PublisherId>(names_.size());
  names_.push_back(name);
  ids_.emplace(name, id);
  return id;
}

std::string PublisherNames::nameOf(PublisherId id) const {
  return names_[static_cast<std::size_t>(id)];
}

std::string whoSends(const std::string& first, const std::string& second) {
  if (first.empty() && second.empty()) {
    return "somebody sends";
  }
  if (first.empty() || second.empty() || first == second) {
    return quoted(first.empty() ? second : first) + " sends";
  }
  return quoted(first) + " and " + quoted(second) + " send";
}

}  // namespace collision_monitor
