// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/init.h>
#include <ros/param.h>

#include "read_robot.h"
#include "ros_edge/parameters/resource_loader.h"

namespace collision_monitor::fit_tool {

std::string readParameter(const std::string& name, SetupReport& report) {
  // Subscribes to nothing, and leaves Ctrl-C unchanged.
  ros::init(ros::M_string(), "robot_reader",
            ros::init_options::AnonymousName | ros::init_options::NoSigintHandler);
  std::string text;
  if (!ros::param::get(name, text)) {
    report.errors.push_back({"option --param", "no parameter '" + name + "', or no roscore",
                             "a parameter that holds the text of a URDF"});
  }
  return text;
}

ResourceLoader makeLoader(const RobotSource& source) {
  LoadRules rules;
  rules.schemes = source.schemes;
  rules.package_roots.assign(source.package_roots.begin(), source.package_roots.end());
  rules.package_places = "below --package-root, or where ROS_PACKAGE_PATH leads to";
  return makeResourceLoader(rules);
}

}  // namespace collision_monitor::fit_tool
