// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <string>

#include "ros_edge/parameters/monitor_setup.h"

namespace collision_monitor {

/// "watching 2 robots in frame 'base': 24 shapes, 120 pairs of links, at 100 Hz; not checked: 12
/// that meet at a joint, 3 hidden by ignore_pairs; 1 warning".
std::string summaryOf(const MonitorSetup& setup);

/// The summary and every warning of the set-up, in the log.
void logSetup(const MonitorSetup& setup);

/// Every problem of a set-up that failed, one line each, in the log.
void logFailure(const std::exception& error);

}  // namespace collision_monitor
