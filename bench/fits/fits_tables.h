// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "collision_monitor/model/robot_model.h"

/// Shared by the tables of fits_figures.cpp.
namespace collision_monitor::test {

struct Arguments {
  std::string urdf;       ///< file
  std::string directory;  ///< where relative names of meshes start
  std::string root;       ///< where package:// starts
  std::string option;     ///< the rest of the command

  int number() const { return std::stoi(option); }
};

/// @throws SetupError if the robot cannot be read.
RobotModel readModel(const Arguments& arguments);

/// Visits every mesh with the name of its link.
void forMeshes(const RobotModel& model,
               const std::function<void(const std::string&, const TriangleMesh&)>& visit);

/// Times of fit, sphere tree and inner shapes of meshes with at least that many triangles. "-" as
/// the URDF is a closed ball with bumps, of 50,700 triangles. Processor time, median of five.
void printTimes(const Arguments& arguments);

/// Times of reading and fitting a robot with the default limits, without a cache.
void printLoad(const Arguments& arguments);

}  // namespace collision_monitor::test
