// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/model/kinematics.h"

namespace collision_monitor {

/// Positions of some joints over time, given by waypoints. Between two waypoints, joints move at
/// constant speed or, if velocities are given, on the cubic that has both positions and velocities.
///
/// Units: radians, metres, seconds.
struct JointPath {
  std::vector<JointId> joints;     ///< revolute, continuous or prismatic; no mimic joints
  std::vector<double> times;       ///< of the waypoints, increasing
  std::vector<double> positions;   ///< by waypoint, then by joint
  std::vector<double> velocities;  ///< likewise, or empty

  double positionAt(std::size_t waypoint, std::size_t joint) const noexcept {
    return positions[waypoint * joints.size() + joint];
  }
};

/// Whether every number is finite, times increase, sizes agree, and there is a waypoint.
bool isSound(const JointPath& path) noexcept;

/// A part of the motion from waypoint `segment` to the next, as shares of its time, 0 to 1.
struct PathPart {
  std::size_t segment{0};
  double from{0.0};
  double to{1.0};
};

double timeAt(const JointPath& path, std::size_t segment, double share) noexcept;

/// Fills in the variables of the path's joints at a share of the segment's time.
/// @pre the path is sound and has the segment; `positions` has all variables of the model.
void setPositions(const RobotModel& model, const JointPath& path, std::size_t segment, double share,
                  JointPositions& positions) noexcept;

/// The travel of a joint in this part, back and forth added up: [rad] or [m], exact.
double travelOf(const JointPath& path, const PathPart& part, std::size_t joint) noexcept;

/// How a joint moves about the middle of a part: at the share s of its half, from -1 to 1, it is
/// within `bend` of its position in the middle plus s * half. [rad] or [m]
struct JointStep {
  double half{0.0};
  double bend{0.0};
};

JointStep stepOf(const JointPath& path, const PathPart& part, std::size_t joint) noexcept;

/// The same for the segments from way-point `first` to `last`, about way-point `middle`.
JointStep stepOf(const JointPath& path, std::size_t first, std::size_t middle, std::size_t last,
                 std::size_t joint) noexcept;

}  // namespace collision_monitor
