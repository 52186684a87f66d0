// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "robot.h"

namespace collision_monitor::python {

/// Writes a pose as 16 numbers, row by row.
void writePose(const Pose& pose, double* rows);

/// Adds what does not depend on a state: variables, links, pairs, shapes, limits, and the text that
/// Python prints.
void addLists(pybind11::class_<Robot, SharedRobot>& type);

}  // namespace collision_monitor::python
