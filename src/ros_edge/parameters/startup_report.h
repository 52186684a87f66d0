// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <string>

#include "ros_edge/parameters/monitor_setup.h"
#include "ros_edge/threads/log_thread.h"

namespace collision_monitor {

/// "watching 2 robots in frame 'base': 24 shapes, 120 pairs of links, at 100 Hz; not checked: 12
/// that meet at a joint, 3 hidden by ignore_pairs; 1 warning".
std::string summaryOf(const MonitorSetup& setup);

/// Logs the summary and every warning of the set-up.
void logSetup(const MonitorSetup& setup, LogThread& log);

/// Logs every problem of a failed set-up, one line each.
void logFailure(const std::exception& error);

/// Logs the progress of fitting if it takes long, as at a first start with large meshes.
FitProgress logLongFitting();

}  // namespace collision_monitor
