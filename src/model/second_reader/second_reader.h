// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/model/robot_model.h"
#include "collision_monitor/model/urdf_reader.h"

namespace collision_monitor {

/// A second opinion on a model: what urdfdom, the URDF parser of ROS, reads in the same texts.
/// Compares links, joints, their types, ends, origins, axes, limits and mimics, and shapes. A
/// difference is a warning that names both readings, unless docs/decisions/urdf-reader.md has it
/// among those that are meant.
///
/// Error: numbers are the same within 1e-9, rotations within 1e-6.
/// Limits: says nothing of a robot that urdfdom refuses, nor of one that is not for it: of more
/// than 2,000 links, 16 MB, or bytes that its parser is not safe with. Of many differences the
/// first few. Throws nothing but std::bad_alloc; may run beside anything else, but not beside
/// itself.
/// @pre `model` was read from `robots`, without errors.
std::vector<Problem> askSecondReader(const std::vector<RobotDescription>& robots,
                                     const RobotModel& model);

}  // namespace collision_monitor
