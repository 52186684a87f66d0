// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/node/node_arguments.h"

#include <ros/init.h>

#include <algorithm>
#include <cstdio>
#include <vector>

namespace collision_monitor {

std::optional<int> answerArguments(int argc, char** argv, const std::string& usage) {
  std::vector<std::string> arguments;
  ros::removeROSArgs(argc, argv, arguments);
  arguments.erase(arguments.begin());
  if (arguments.empty()) {
    return std::nullopt;
  }
  const auto is_help = [](const std::string& one) { return one == "--help" || one == "-h"; };
  if (std::any_of(arguments.begin(), arguments.end(), is_help)) {
    std::fputs(usage.c_str(), stdout);
    return kDone;
  }
  std::fprintf(stderr, "unknown argument '%s'; accepted: NAME:=VALUE, --help\n",
               arguments.front().c_str());
  return kUsageFault;
}

std::optional<int> initNode(int& argc, char** argv, const std::string& name) {
  try {
    ros::init(argc, argv, name);
  } catch (const ros::InvalidNameException& error) {
    // The log needs a node name.
    std::fprintf(stderr, "bad name of the node or of a remapping: %s\n", error.what());
    return kUsageFault;
  }
  return std::nullopt;
}

}  // namespace collision_monitor
