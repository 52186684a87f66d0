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

/// Robots in random configurations and in motion between them.
namespace collision_monitor::test {

/// The first robot of the shared data or urdf/ with this in its name; prints a line if none has.
std::optional<RobotFile> findRobot(const std::string& name);

/// Whether one variable moves it, and no other joint does.
bool isDrawn(const Joint& joint);

/// Draws each of these joints uniformly between its limits, and within 1 m or 3 rad of zero.
JointPositions drawPositions(const RobotModel& model, std::mt19937_64& random);

/// The default of the monitor: distances of meshes to 0.1 mm.
constexpr double kMonitorTolerance = 1e-4;  // [m]

JointPositions between(const JointPositions& from, const JointPositions& to, double share);

/// Every link known, roots at the origin.
LinkPoses posesAt(const RobotModel& model, const JointPositions& positions);

/// A path on which all movable joints move evenly through four random configurations: 100
/// way-points a tenth of a second apart.
JointPath randomPath(const RobotModel& model);

/// Moves robots from one random configuration towards the next for half a second, the fastest joint
/// at a speed, with poses at a rate. Later moves have other configurations; always the same ones.
class Mover {
 public:
  /// @param speed [rad/s] @param model outlives this.
  Mover(const RobotModel& model, double rate, double speed);

  /// The poses of the next move, with velocities; stamps continue.
  std::vector<LinkPoses> next();

 private:
  const RobotModel& model_;
  double rate_;
  double speed_;
  std::mt19937_64 random_{20260101};
  std::int64_t stamp_ns_{1'000'000'000};
};

}  // namespace collision_monitor::test
