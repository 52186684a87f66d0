// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include "ros_edge/node/monitor.h"
#include "ros_edge/node/node_arguments.h"
#include "ros_edge/parameters/startup_report.h"

namespace {

const char* const kUsage =
    "Watches robots for collisions with themselves and each other.\n"
    "\n"
    "Usage: rosrun collision_monitor monitor [NAME:=VALUE ...]\n"
    "       roslaunch collision_monitor monitor.launch [ARGUMENT:=VALUE ...]\n"
    "\n"
    "  robot_description:=NAME  a topic, service or parameter under another name\n"
    "  _rate:=200               a private parameter; config/monitor.yaml of this package has all\n"
    "  __name:=NAME             name of the node; __ns, __log, __ip as of every ROS node\n"
    "  --help                   this text\n"
    "\n"
    "Reads      parameters robot_description, robot_description_semantic (if there), and its own\n"
    "Listens to /tf, /tf_static, joint_states, /clock with use_sim_time\n"
    "Publishes  below its name: state, state_is_valid, speed_scale, contacts, distances,\n"
    "           warnings, markers, objects; for robots of the parameter `robots` also\n"
    "           robots/NAME/speed_scale and robots/NAME/state_is_valid; and /diagnostics\n"
    "Serves     below its name: get_distances, check_trajectory, check_states, explain_pair,\n"
    "           set_pairs, set_limits, apply_objects, get_objects, set_enabled, reload\n"
    "\n"
    "Exit code: 0, it was told to end. 1, the set-up is at fault; all faults are in the log.\n"
    "2, the command line is at fault.\n";

}  // namespace

int main(int argc, char** argv) {
  using namespace collision_monitor;
  if (const auto code = answerArguments(argc, argv, kUsage)) {
    return *code;
  }
  if (const auto code = initNode(argc, argv, "collision_monitor")) {
    return *code;
  }
  // Outside the try block: ROS shuts its log down when the last handle ends.
  const ros::NodeHandle private_node("~");
  try {
    const Monitor monitor(private_node, ros::this_node::getName());
    ros::spin();
  } catch (const std::exception& error) {
    logFailure(error);
    return kFault;
  } catch (const Interrupted&) {
    return kDone;  // asked to end before it began
  }
  return kDone;
}
