// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "collision_monitor/model/robot_model.h"

/// Links that are no links of robots.
namespace collision_monitor {

/// Whether a link is an object, or a frame that carries objects.
inline bool isOfWorld(const RobotModel& model, LinkId link) {
  return model.robots[index(model.link(link).robot)].is_world;
}

/// Whether a link is an object, which a fixed joint joins to what carries it.
inline bool isObject(const RobotModel& model, LinkId link) {
  return isOfWorld(model, link) && model.link(link).parent_joint;
}

/// Objects that stand together and have one carrier: links [first, last).
struct ObjectRun {
  LinkId carrier{};
  std::size_t first{0};
  std::size_t last{0};
};

/// All objects, in order of link.
std::vector<ObjectRun> objectRuns(const RobotModel& model);

/// The number of links of a robot without its objects, which stand last: all links, or the frame
/// that carries objects, or none.
inline std::size_t ownLinkCount(const RobotModel& model, const Robot& robot) {
  return robot.is_world ? (model.links[robot.first_link].parent_joint ? 0 : 1) : robot.link_count;
}

/// Calls `use` with the index of each link of a robot that is no object.
template <class Use>
void forOwnLinks(const RobotModel& model, const Robot& robot, const Use& use) {
  const std::size_t last = robot.first_link + ownLinkCount(model, robot);
  for (std::size_t i = robot.first_link; i < last; ++i) {
    use(i);
  }
}

/// first_from_other, of two objects that one carrier carries.
Pose poseBeside(const RobotModel& model, LinkId first, LinkId other);

/// Whether there are objects, or frames that carry some.
inline bool hasObjects(const RobotModel& model) {
  return std::any_of(model.robots.begin(), model.robots.end(),
                     [](const Robot& robot) { return robot.is_world; });
}

/// The number of robots, without those that objects form.
inline std::size_t robotCount(const RobotModel& model) {
  return static_cast<std::size_t>(
      std::count_if(model.robots.begin(), model.robots.end(),
                    [](const Robot& robot) { return !robot.is_world; }));
}

}  // namespace collision_monitor
