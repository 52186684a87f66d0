// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include <cstdio>

#include "collision_monitor/ros_edge/monitor.h"
#include "ros_edge/startup_report.h"

int main(int argc, char** argv) {
  try {
    ros::init(argc, argv, "collision_monitor");
  } catch (const ros::InvalidNameException& error) {
    std::fprintf(stderr, "bad name of the node or of a remapping: %s\n", error.what());
    return 1;  // without a name there is no log
  }
  // Outside of the try: when the last handle ends, ROS shuts its log down.
  const ros::NodeHandle private_node("~");
  try {
    const collision_monitor::Monitor monitor(private_node, ros::this_node::getName());
    // Two threads: a reload that takes long must not delay diagnostics.
    ros::MultiThreadedSpinner spinner(2);
    spinner.spin();
  } catch (const std::exception& error) {
    collision_monitor::logFailure(error);
    return 1;
  }
  return 0;
}
