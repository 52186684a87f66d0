// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
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

/// A link in a sentence: "hand", "object table", "frame conveyor".
inline std::string nameInText(const RobotModel& model, LinkId link) {
  const std::string& name = model.link(link).name;
  return isObject(model, link) ? "object " + name : isOfWorld(model, link) ? "frame " + name : name;
}

/// The first link that is of the world; the number of links if none is.
/// @pre robots stand before those that objects form
inline LinkId firstOfWorld(const RobotModel& model) {
  const auto first = std::find_if(model.robots.begin(), model.robots.end(),
                                  [](const Robot& robot) { return robot.is_world; });
  return idAt<LinkId>(first == model.robots.end() ? model.links.size() : first->first_link);
}

/// The number of robots, without those that objects form.
inline std::size_t robotCount(const RobotModel& model) {
  return static_cast<std::size_t>(
      std::count_if(model.robots.begin(), model.robots.end(),
                    [](const Robot& robot) { return !robot.is_world; }));
}

/// By LinkId: the index of the robot that moves it, also as the link that carries an object; the
/// number of robots if none does. @pre robots stand before those that objects form
inline std::vector<std::uint32_t> findMovers(const RobotModel& model) {
  const auto none = static_cast<std::uint32_t>(robotCount(model));
  std::vector<std::uint32_t> movers;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const Link& link = model.links[i];
    if (!isOfWorld(model, idAt<LinkId>(i))) {
      movers.push_back(static_cast<std::uint32_t>(index(link.robot)));
    } else {
      movers.push_back(link.parent_joint ? movers[index(model.joint(*link.parent_joint).parent)]
                                         : none);
    }
  }
  return movers;
}

}  // namespace collision_monitor
