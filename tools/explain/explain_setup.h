// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/model/kinematics.h"
#include "collision_monitor/pipeline/setup.h"
#include "explain_options.h"

namespace collision_monitor::explain_tool {

/// What the command line asks about.
struct Explained {
  CycleSetup setup;          ///< of the robot and the objects, as a monitor would make it
  JointPositions positions;  ///< of the robot
};

/// Reads everything that the command line names, and warns of what it does in vain.
/// @throws SetupError with all faults; afterwards there are two links or objects of these names
Explained makeSetup(const Options& options);

}  // namespace collision_monitor::explain_tool
