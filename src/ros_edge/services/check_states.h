// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <collision_monitor/CheckStates.h>

#include <functional>

#include "ros_edge/parameters/monitor_setup.h"
#include "ros_edge/poses/newest_state.h"

namespace collision_monitor {

/// Answers the service of that name for states of the named joints. All other joints stay where the
/// newest poses have them. Uses its own buffers.
/// @param progress called now and then with the share done, 0 to 1; false: give up
void answerCheckStates(const MonitorSetup& current, const NewestState& newest,
                       const std::function<bool(double)>& progress,
                       const CheckStates::Request& request, CheckStates::Response& response);

}  // namespace collision_monitor
