// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "collision_monitor/model/kinematics.h"
#include "model/kinematics/joint_path.h"
#include "pipeline/data/cycle_data.h"
#include "support/robots/file_loader.h"

/// Robots in random configurations and on the way between them.
namespace collision_monitor::test {

/// The first of the shared data or urdf/ with this in its name; if there is none, says so.
std::optional<RobotFile> findRobot(const std::string& name);

/// One variable moves it, and no other joint does.
bool isDrawn(const Joint& joint);

/// Each of these joints anywhere between its limits, where these are not too wide.
JointPositions drawPositions(const RobotModel& model, std::mt19937_64& random);

/// As a monitor is set up by default: it tells distances of meshes to 0.1 mm.
constexpr double kMonitorTolerance = 1e-4;  // [m]

JointPositions between(const JointPositions& from, const JointPositions& to, double share);

/// Every link known, roots at the origin.
LinkPoses posesAt(const RobotModel& model, const JointPositions& positions);

/// All joints that move go evenly from one random configuration to the next, and to two more: 100
/// way-points a tenth of a second apart.
JointPath randomPath(const RobotModel& model);

/// The robots go from one random configuration towards the next, the fastest joint at a speed, for
/// half a second, and poses come at a rate; then from and to others. Always the same moves.
class Mover {
 public:
  /// @param speed [rad/s] @param model outlives this.
  Mover(const RobotModel& model, double rate, double speed);

  /// The poses of the next move, with velocities; stamps go on.
  std::vector<LinkPoses> next();

 private:
  const RobotModel& model_;
  double rate_;
  double speed_;
  std::mt19937_64 random_{20260101};
  std::int64_t stamp_ns_{1'000'000'000};
};

}  // namespace collision_monitor::test
