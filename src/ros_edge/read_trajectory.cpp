// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/read_trajectory.h"

#include <algorithm>
#include <cmath>

#include "ros_edge/apply_joints.h"

namespace collision_monitor {
namespace {

using trajectory_msgs::JointTrajectory;
using trajectory_msgs::JointTrajectoryPoint;

std::string pointText(std::size_t point) { return "points[" + std::to_string(point) + "]"; }

/// One number a joint, and every number finite.
void checkNumbers(const JointTrajectory& trajectory, std::size_t point,
                  const std::vector<double>& numbers, const char* field,
                  std::vector<std::string>& faults) {
  const std::string where = pointText(point) + "." + field;
  if (numbers.size() != trajectory.joint_names.size()) {
    faults.push_back(where + " has " + std::to_string(numbers.size()) + " numbers for " +
                     std::to_string(trajectory.joint_names.size()) +
                     " joints; give one for each joint");
    return;
  }
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (!std::isfinite(numbers[i])) {
      faults.push_back(where + " of joint '" + trajectory.joint_names[i] + "' is not finite");
    }
  }
}

std::vector<std::string> findFaults(const JointTrajectory& trajectory) {
  if (trajectory.points.empty()) {
    return {"the trajectory has no points; give at least one"};
  }
  std::vector<std::string> faults;
  const bool has_velocities = !trajectory.points.front().velocities.empty();
  for (std::size_t i = 0; i < trajectory.points.size(); ++i) {
    const JointTrajectoryPoint& point = trajectory.points[i];
    checkNumbers(trajectory, i, point.positions, "positions", faults);
    if (has_velocities != !point.velocities.empty()) {
      faults.push_back(pointText(i) + ".velocities " +
                       (has_velocities ? "is empty" : "is not empty") +
                       "; give velocities at every point or at none");
    } else if (has_velocities) {
      checkNumbers(trajectory, i, point.velocities, "velocities", faults);
    }
    if (i > 0 && !(trajectory.points[i - 1].time_from_start < point.time_from_start)) {
      faults.push_back(pointText(i) +
                       ".time_from_start is not later than that of the point before it");
    }
  }
  return faults;
}

void fillPath(const RobotModel& model, const JointTrajectory& trajectory, JointPath& path) {
  std::vector<std::size_t> places;  // joints that follow another are given by that one
  for (std::size_t i = 0; i < trajectory.joint_names.size(); ++i) {
    const JointId joint = *model.findJoint(trajectory.joint_names[i]);
    if (!model.joint(joint).mimic) {
      path.joints.push_back(joint);
      places.push_back(i);
    }
  }
  for (const JointTrajectoryPoint& point : trajectory.points) {
    path.times.push_back(point.time_from_start.toSec());
    for (const std::size_t place : places) {
      path.positions.push_back(point.positions[place]);
      if (!point.velocities.empty()) {
        path.velocities.push_back(point.velocities[place]);
      }
    }
  }
}

}  // namespace

std::vector<std::string> readTrajectory(const RobotModel& model, const JointTrajectory& trajectory,
                                        JointPath& path, LinkPoses& start) {
  std::vector<std::string> faults = findFaults(trajectory);
  sensor_msgs::JointState first;
  first.name = trajectory.joint_names;
  first.position.assign(first.name.size(), 0.0);
  if (faults.empty()) {
    first.position = trajectory.points.front().positions;
  }
  if (first.name.empty()) {
    faults.emplace_back("joint_names is empty; name the joints that move");
  }
  const std::vector<std::string> of_joints = applyJoints(model, first, start);
  faults.insert(faults.end(), of_joints.begin(), of_joints.end());
  if (faults.empty()) {
    fillPath(model, trajectory, path);
  }
  return faults;
}

}  // namespace collision_monitor
