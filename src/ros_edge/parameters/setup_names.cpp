// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "model/object_links.h"
#include "ros_edge/parameters/monitor_setup.h"
#include "ros_edge/poses/transform_store.h"

/// What a set-up names: topics, frames and the end of mutes.
namespace collision_monitor {

std::optional<RuleEnd> lastMuteOf(const MonitorSetup& setup) {
  std::optional<RuleEnd> last;
  for (const LinkPair& pair : setup.setup.link_pairs) {
    if (pair.reason == PairReason::muted) {
      const RuleEnd end = setup.rule_ends[pair.rule];
      last = last ? std::max(*last, end) : end;
    }
  }
  return last;
}

std::vector<std::string> jointTopics(const MonitorSetup& setup) {
  std::vector<std::string> topics;
  for (const Robot& robot : setup.setup.model.robots) {
    topics.push_back(robot.is_world ? "" : setup.parameters.joint_states);
  }
  // An empty list means one robot. Robots that are missing have no place among those of the model.
  std::size_t robot = 0;
  for (std::size_t i = 0; i < setup.parameters.robots.size(); ++i) {
    if (i < setup.listed.size() && !setup.listed[i].id) {
      continue;
    }
    const std::string& own = setup.parameters.robots[i].joint_states;
    topics[robot] = own.empty() ? topics[robot] : own;
    ++robot;
  }
  return topics;
}

std::vector<std::string> frameNames(const MonitorSetup& setup) {
  std::vector<std::string> names{setup.world_frame};
  const RobotModel& model = setup.setup.model;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    if (!isObject(model, idAt<LinkId>(i))) {
      names.push_back(model.links[i].frame);
    }
  }
  return names;
}

}  // namespace collision_monitor
