// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <random>
#include <string>

#include "collision_monitor/model/kinematics.h"
#include "collision_monitor/pipeline/cycle_data.h"
#include "support/file_loader.h"

/// Robots in random configurations and on the way between them.
namespace collision_monitor::test {

/// The first of the shared data or urdf/ with this in its name; if there is none, says so.
std::optional<RobotFile> findRobot(const std::string& name);

/// Each joint with one variable anywhere between its limits, where these are not too wide.
JointPositions drawPositions(const RobotModel& model, std::mt19937_64& random);

JointPositions between(const JointPositions& from, const JointPositions& to, double share);

/// Every link known, roots at the origin.
LinkPoses posesAt(const RobotModel& model, const JointPositions& positions);

}  // namespace collision_monitor::test
