// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <collision_monitor/GetDistances.h>

#include "ros_edge/parameters/monitor_setup.h"
#include "ros_edge/poses/newest_state.h"

namespace collision_monitor {

/// Answers the service of that name for the newest poses, optionally with some joints moved.
/// Measures every requested pair at any distance. Uses its own buffers.
void answerGetDistances(const MonitorSetup& current, const NewestState& newest,
                        const GetDistances::Request& request, GetDistances::Response& response);

}  // namespace collision_monitor
