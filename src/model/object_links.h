// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

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
