// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <collision_monitor/CheckTrajectory.h>

#include "pipeline/trajectory/check_trajectory.h"
#include "ros_edge/parameters/monitor_setup.h"
#include "ros_edge/poses/newest_state.h"

namespace collision_monitor {

/// Answers the service of that name. Joints that the trajectory does not name stay as in `newest`;
/// the others move from there to its first point. Uses its own buffers.
/// @param progress as TrajectoryOptions::progress
void answerCheckTrajectory(const MonitorSetup& current, const NewestState& newest,
                           const std::function<bool(double)>& progress,
                           const CheckTrajectory::Request& request,
                           CheckTrajectory::Response& response);

/// Whether a pair that is not the nearest is told: long answers leave out what stays far.
/// @param margin [m] of the search
bool isTold(const TrajectoryReport& report, double margin, LinkPairIndex pair) noexcept;

}  // namespace collision_monitor
