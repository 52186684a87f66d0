// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <unordered_map>

#include "collision_monitor/model/robot_model.h"
#include "model/frame_names.h"

namespace collision_monitor {

/// Finds links and joints of one robot by their URDF names, fast, for documents with thousands of
/// names.
class NameIndex {
 public:
  NameIndex(const RobotModel& model, RobotId robot) {
    const Robot& own = model.robots[index(robot)];
    tf_prefix_ = own.tf_prefix;
    for (std::size_t i = 0; i < own.link_count; ++i) {
      const LinkId link = idAt<LinkId>(own.first_link + i);
      links_.emplace(model.link(link).name, link);
    }
    for (std::size_t i = 0; i < own.joint_count; ++i) {
      const JointId joint = idAt<JointId>(own.first_joint + i);
      joints_.emplace(model.joint(joint).name, joint);
    }
  }

  std::optional<LinkId> link(const std::string& name) const { return find(links_, name); }
  std::optional<JointId> joint(const std::string& name) const { return find(joints_, name); }

 private:
  template <class Id>
  std::optional<Id> find(const std::unordered_map<std::string, Id>& ids,
                         const std::string& name) const {
    const auto found = ids.find(prefixed(tf_prefix_, name));
    return found == ids.end() ? std::nullopt : std::optional<Id>(found->second);
  }

  std::string tf_prefix_;
  std::unordered_map<std::string, LinkId> links_;
  std::unordered_map<std::string, JointId> joints_;
};

}  // namespace collision_monitor
