// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>

#include "ros_edge/parameters/parameters.h"

/// When cycles begin and states are due, by wall time.
namespace collision_monitor {

using SteadyClock = std::chrono::steady_clock;

struct CyclePace {
  SteadyClock::time_point planned_start;  ///< of the cycle at hand
  SteadyClock::time_point last_state;     ///< when it was published
};

/// [s] Between two cycles, as the parameters ask for. A timer slower than the heartbeat would let
/// the heart stop.
double periodOf(const Parameters& parameters);
/// [s] How far apart cycles may be at most: by poses, these may stay away.
double longestPeriodOf(const Parameters& parameters);

/// The planned start of the next cycle. One that came late shifts those after it; they do not catch
/// up in a burst. Poses may come early after one that came late, so they may be an interval ahead.
SteadyClock::time_point nextStart(const Parameters& parameters, const CyclePace& pace,
                                  SteadyClock::time_point now);

/// When the heartbeat is owed.
SteadyClock::time_point nextHeartbeat(const Parameters& parameters, const CyclePace& pace);

/// Whether the heartbeat would come late if it waited for the next cycle.
bool isStateDue(const Parameters& parameters, const CyclePace& pace, SteadyClock::time_point now);

/// Until when to wait for poses: links that grow stale meanwhile must be told soon.
SteadyClock::time_point endOfWait(const Parameters& parameters, const CyclePace& pace,
                                  SteadyClock::time_point now);

}  // namespace collision_monitor
