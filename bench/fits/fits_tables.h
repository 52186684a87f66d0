// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "collision_monitor/model/robot_model.h"

/// What the tables of fits_figures.cpp share.
namespace collision_monitor::test {

struct Arguments {
  std::string urdf;       ///< file
  std::string directory;  ///< where relative names of meshes start
  std::string root;       ///< where package:// does
  std::string option;     ///< what else the command takes

  int number() const { return std::stoi(option); }
};

/// @throws SetupError when the robot cannot be read.
RobotModel readModel(const Arguments& arguments);

/// Visits every mesh with the name of its link.
void forMeshes(const RobotModel& model,
               const std::function<void(const std::string&, const TriangleMesh&)>& visit);

/// Fit, sphere tree and inner shapes of meshes with at least so many triangles; "-" for the URDF
/// is a closed ball with bumps, of 50,700 triangles. The time is the processor's, median of five.
void printTimes(const Arguments& arguments);

/// Reading and fitting a robot with the default limits, without a cache.
void printLoad(const Arguments& arguments);

}  // namespace collision_monitor::test
