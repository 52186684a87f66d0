// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/model/robot_model.h"

#include <algorithm>

namespace collision_monitor {
namespace {

template <class Id, class Named>
std::optional<Id> findByName(const std::vector<Named>& all, const std::string& name) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Named& one) { return one.name == name; });
  if (found == all.end()) {
    return std::nullopt;
  }
  return idAt<Id>(static_cast<std::size_t>(found - all.begin()));
}

}  // namespace

std::optional<LinkId> RobotModel::findLink(const std::string& name) const {
  for (std::size_t i = 0; i < links.size(); ++i) {
    const std::size_t robot = index(links[i].robot);
    const bool carries_objects =
        robot < robots.size() && robots[robot].is_world && !links[i].parent_joint;
    if (links[i].name == name && !carries_objects) {
      return idAt<LinkId>(i);
    }
  }
  return std::nullopt;
}

std::optional<JointId> RobotModel::findJoint(const std::string& name) const {
  return findByName<JointId>(joints, name);
}

}  // namespace collision_monitor
