// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "robot_options.h"

namespace CLI {
class App;
}

namespace collision_monitor::pairs_tool {

/// A further robot: "left=arm.urdf".
struct OtherRobot {
  std::string prefix;
  std::string urdf;
};

/// Where the root of a robot stands in the world: "left=x,y,z" or "left=x,y,z,roll,pitch,yaw".
struct Place {
  std::string prefix;  ///< of the robot; empty: of the first one if it has none
  Eigen::Vector3d xyz{Eigen::Vector3d::Zero()};  ///< [m]
  Eigen::Vector3d rpy{Eigen::Vector3d::Zero()};  ///< [rad] as in a URDF
};

struct SeveralRobots {
  std::string prefix;  ///< of the first robot
  std::vector<OtherRobot> others;
  std::vector<Place> places;
};

/// Adds --prefix, --with and --place.
void addSeveralRobots(CLI::App& app, SeveralRobots& robots);

/// @throws CLI::ValidationError if a place names no robot or a robot twice, or two robots have the
/// same prefix.
void checkSeveralRobots(const SeveralRobots& robots);

}  // namespace collision_monitor::pairs_tool
