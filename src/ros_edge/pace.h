// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>

#include "ros_edge/parameters/parameters.h"

/// When cycles start and states are due, by wall time.
namespace collision_monitor {

using SteadyClock = std::chrono::steady_clock;

struct CyclePace {
  SteadyClock::time_point planned_start;  ///< of the current cycle
  SteadyClock::time_point last_state;     ///< when the last state was published
  SteadyClock::time_point woken;          ///< when the current cycle started indeed
};

/// [s] Interval of cycles, as the parameters ask. A timer is never slower than the heartbeat, which
/// would otherwise fail.
double periodOf(const Parameters& parameters);
/// [s] The longest interval of cycles. With the trigger `pose`, poses may be absent.
double longestPeriodOf(const Parameters& parameters);

/// The planned start of the next cycle. A late cycle shifts the following ones; they do not catch
/// up in a burst. After a late pose the next may come early, so planned starts may be up to one
/// interval ahead.
SteadyClock::time_point nextStart(const Parameters& parameters, const CyclePace& pace,
                                  SteadyClock::time_point now);

/// When the current cycle must have ended. One that a timer starts has a period from its planned
/// start on; one that poses start, from when they woke the thread.
SteadyClock::time_point endOfCycle(const Parameters& parameters, const CyclePace& pace);

/// When the heartbeat is due.
SteadyClock::time_point nextHeartbeat(const Parameters& parameters, const CyclePace& pace);

/// Whether the heartbeat would be late if it waited for the next cycle.
bool isStateDue(const Parameters& parameters, const CyclePace& pace, SteadyClock::time_point now);

/// When to stop waiting for poses: links that grow stale in the meantime must be reported soon.
SteadyClock::time_point endOfWait(const Parameters& parameters, const CyclePace& pace,
                                  SteadyClock::time_point now);

}  // namespace collision_monitor
