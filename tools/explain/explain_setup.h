// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/pipeline/setup.h"
#include "explain_options.h"

namespace collision_monitor::explain_tool {

/// The robot with the objects of its world, whose pairs have the reasons and limits that a monitor
/// would give them. Warns of rules that select nothing.
/// @throws SetupError
CycleSetup makeSetup(const Options& options);

}  // namespace collision_monitor::explain_tool
