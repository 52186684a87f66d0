// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/services/read_trajectory.h"

#include <algorithm>
#include <cmath>

#include "model/few_texts.h"
#include "model/number_text.h"
#include "model/place.h"
#include "ros_edge/poses/apply_joints.h"

namespace collision_monitor {
namespace {

using trajectory_msgs::JointTrajectory;
using trajectory_msgs::JointTrajectoryPoint;

std::string pointText(std::size_t point) { return "points[" + std::to_string(point) + "]"; }

std::string jointFault(const std::string& field, const std::string& joint,
                       const std::string& fault) {
  return field + " of joint " + quoted(joint) + " " + fault;
}

/// Checks that there is one valid number per joint.
void checkNumbers(const JointTrajectory& trajectory, std::size_t point,
                  const std::vector<double>& numbers, const char* field, FewTexts& faults) {
  const std::string where = pointText(point) + "." + field;
  if (numbers.size() != trajectory.joint_names.size()) {
    faults.add([&] {
      return where + " has " + counted(numbers.size(), "number") + " for " +
             counted(trajectory.joint_names.size(), "joint") + "; give one for each joint";
    });
    return;
  }
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::string fault = numberFault(numbers[i]);
    if (!fault.empty()) {
      faults.add([&] { return jointFault(where, trajectory.joint_names[i], fault); });
    }
  }
}

/// Without subtracting ros::Duration, which throws if the difference is out of its range.
double timeOf(const JointTrajectoryPoint& point) { return point.time_from_start.toSec(); }

/// Checks that the time is 0 or more, and later than that of the point before.
void checkTime(const JointTrajectory& trajectory, std::size_t point, FewTexts& faults) {
  const double time = timeOf(trajectory.points[point]);
  const double before = point == 0 ? 0.0 : timeOf(trajectory.points[point - 1]);
  const auto found = [&] {
    return pointText(point) + ".time_from_start is " + shortText(time) + " s";
  };
  if (point == 0 && time < 0.0) {
    faults.add([&] { return found() + "; accepted: 0 s or later"; });
  } else if (point > 0 && time <= before) {
    faults.add([&] {
      return found() + "; accepted: later than the " + shortText(before) +
             " s of the point before it";
    });
  }
}

/// Checks how far cubics overshoot between two points, whose positions may be near each other. Time
/// 0 is beside the first.
/// @pre the points have no other faults
void checkSwings(const JointTrajectory& trajectory, FewTexts& faults) {
  const std::vector<JointTrajectoryPoint>& points = trajectory.points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double before = i == 0 ? 0.0 : timeOf(points[i - 1]);
    const std::size_t after = std::min(i + 1, points.size() - 1);
    const double time =
        std::max(timeOf(points[after]) - timeOf(points[i]), timeOf(points[i]) - before);
    for (std::size_t k = 0; k < points[i].velocities.size(); ++k) {
      const double farthest = std::abs(points[i].velocities[k]) * time;
      if (farthest > kFarthest) {
        const std::string fault = "is " + shortText(points[i].velocities[k]) + ", which leads " +
                                  shortText(farthest) +
                                  " far until the point next to it; accepted: at most 1e9 far";
        faults.add([&] {
          return jointFault(pointText(i) + ".velocities", trajectory.joint_names[k], fault);
        });
      }
    }
  }
}

std::vector<std::string> findFaults(const JointTrajectory& trajectory) {
  if (trajectory.points.empty()) {
    return {"the trajectory has no points; give at least one"};
  }
  FewTexts faults;
  const bool has_velocities = !trajectory.points.front().velocities.empty();
  for (std::size_t i = 0; i < trajectory.points.size(); ++i) {
    const JointTrajectoryPoint& point = trajectory.points[i];
    checkNumbers(trajectory, i, point.positions, "positions", faults);
    if (has_velocities != !point.velocities.empty()) {
      faults.add([&] {
        return pointText(i) + ".velocities " + (has_velocities ? "is empty" : "is not empty") +
               "; give velocities at every point or at none";
      });
    } else if (has_velocities) {
      checkNumbers(trajectory, i, point.velocities, "velocities", faults);
    }
    checkTime(trajectory, i, faults);
  }
  if (faults.all().empty()) {
    checkSwings(trajectory, faults);
  }
  return faults.all();
}

void fillPath(const RobotModel& model, const JointTrajectory& trajectory, JointPath& path) {
  std::vector<std::size_t> places;  // mimic joints are left out; they follow their sources
  for (std::size_t i = 0; i < trajectory.joint_names.size(); ++i) {
    const JointId joint = *model.findJoint(trajectory.joint_names[i]);
    if (!model.joint(joint).mimic) {
      path.joints.push_back(joint);
      places.push_back(i);
    }
  }
  for (const JointTrajectoryPoint& point : trajectory.points) {
    path.times.push_back(timeOf(point));
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
    faults.emplace_back(takesPositions(model)
                            ? "joint_names is empty; name the joints that move"
                            : "this robot has no joint that a trajectory can move");
  }
  const std::vector<std::string> of_joints = applyJoints(model, first, "joint_names", start);
  faults.insert(faults.end(), of_joints.begin(), of_joints.end());
  if (faults.empty()) {
    fillPath(model, trajectory, path);
  }
  return faults;
}

std::vector<std::string> addWayToFirstPoint(const RobotModel& model, const NewestState& newest,
                                            JointPath& path, LinkPoses& start) {
  if (path.times.front() == 0.0) {
    return {};
  }
  sensor_msgs::JointState now;
  std::vector<std::string> unknown;
  for (std::size_t i = 0; i < path.joints.size(); ++i) {
    const auto position = newestPosition(model, newest, path.joints[i], path.positionAt(0, i));
    now.name.push_back(model.joint(path.joints[i]).name);
    now.position.push_back(position.value_or(0.0));
    if (!position) {
      unknown.push_back(now.name.back());
    }
  }
  if (unknown.empty()) {
    applyJoints(model, now, "joint_names", start);
    path.times.insert(path.times.begin(), 0.0);
    path.positions.insert(path.positions.begin(), now.position.begin(), now.position.end());
    path.velocities.insert(path.velocities.begin(),
                           path.velocities.empty() ? 0 : path.joints.size(), 0.0);
  }
  return unknown;
}

}  // namespace collision_monitor
