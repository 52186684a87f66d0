// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <collision_monitor/SetLimits.h>
#include <collision_monitor/SetPairs.h>

#include <memory>
#include <vector>

#include "ros_edge/parameters/monitor_setup.h"

/// Changes of rules and limits at run time. Each makes a new set-up from the current one, without
/// reading or fitting anything again. A change that fails anywhere changes nothing.
namespace collision_monitor {

/// A set-up to be watched instead; null if nothing changes.
using NextSetup = std::shared_ptr<const MonitorSetup>;

/// Answers the service set_pairs.
/// @param number of this request since start, for the places of its rules
/// @throws Interrupted
NextSetup answerSetPairs(const MonitorSetup& current, RuleEnd now, std::size_t number,
                         const SetPairs::Request& request, SetPairs::Response& response);

/// Answers the service set_limits.
/// @throws Interrupted
NextSetup answerSetLimits(const MonitorSetup& current, const SetLimits::Request& request,
                          SetLimits::Response& response);

/// The set-up without rules that have ended by now; null if none has.
/// @param dropped_limits gets a warning for each rule that loses its limits, because the limits
/// that are left do not fit together
/// @throws SetupError, std::bad_alloc
NextSetup withoutEnded(const MonitorSetup& current, RuleEnd now,
                       std::vector<Problem>& dropped_limits);

/// When the next rule ends; kLasts if none does.
RuleEnd nextEndOf(const MonitorSetup& current);

}  // namespace collision_monitor
