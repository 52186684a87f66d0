// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/model/robot_model.h"
#include "collision_monitor/model/urdf_reader.h"

namespace collision_monitor {

/// Compares a model with what urdfdom, the URDF parser of ROS, reads from the same texts: links,
/// joints with types, ends, origins, axes, limits and mimics, and shapes. A difference is a warning
/// that gives both readings, unless docs/decisions/urdf-reader.md lists it as intended.
///
/// Error: numbers count as equal within 1e-9, rotations within 1e-6.
/// Limits: skips a robot that urdfdom refuses, one with more than 2,000 links or 16 MB, and one
/// with bytes that are unsafe for its parser. Reports only the first few of many differences.
/// Throws nothing but std::bad_alloc. May run in parallel with anything but itself.
/// @pre `model` was read from `robots`, without errors.
std::vector<Problem> askSecondReader(const std::vector<RobotDescription>& robots,
                                     const RobotModel& model);

}  // namespace collision_monitor
