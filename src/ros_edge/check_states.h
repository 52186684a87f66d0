// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <collision_monitor/CheckStates.h>

#include "collision_monitor/pipeline/cycle_data.h"
#include "ros_edge/monitor_setup.h"

namespace collision_monitor {

/// Answers the service of that name: the states of the named joints, all other joints where the
/// newest poses have them. Works with buffers of its own.
void answerCheckStates(const MonitorSetup& current, const LinkPoses& newest,
                       const CheckStates::Request& request, CheckStates::Response& response);

}  // namespace collision_monitor
