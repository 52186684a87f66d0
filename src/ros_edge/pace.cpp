// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/pace.h"

#include <algorithm>

namespace collision_monitor {
namespace {

SteadyClock::duration seconds(double value) {
  return std::chrono::duration_cast<SteadyClock::duration>(std::chrono::duration<double>(value));
}

/// [s] The least mean interval of cycles that are triggered by poses. Poses at `rate` by another
/// clock may come slightly sooner by this one.
double poseIntervalOf(const Parameters& parameters) {
  constexpr double kClockTolerance = 0.01;
  return (1.0 - kClockTolerance) * periodOf(parameters);
}

double idlePeriodOf(const Parameters& parameters) {
  constexpr double kShortest = 1e-3;
  return std::max(kShortest, std::min(1.0 / parameters.heartbeat_rate, 0.25 * parameters.max_age));
}

}  // namespace

double periodOf(const Parameters& parameters) {
  return 1.0 / std::max(parameters.rate, parameters.heartbeat_rate);
}

double longestPeriodOf(const Parameters& parameters) {
  return parameters.trigger == Trigger::timer
             ? periodOf(parameters)
             : std::max(periodOf(parameters), idlePeriodOf(parameters));
}

SteadyClock::time_point nextStart(const Parameters& parameters, const CyclePace& pace,
                                  SteadyClock::time_point now) {
  if (parameters.trigger == Trigger::timer) {
    return std::max(pace.planned_start + seconds(periodOf(parameters)), now);
  }
  const SteadyClock::duration interval = seconds(poseIntervalOf(parameters));
  return std::max(pace.planned_start + interval, now - interval);
}

SteadyClock::time_point endOfCycle(const Parameters& parameters, const CyclePace& pace) {
  return (parameters.trigger == Trigger::timer ? pace.planned_start : pace.woken) +
         seconds(periodOf(parameters));
}

SteadyClock::time_point nextHeartbeat(const Parameters& parameters, const CyclePace& pace) {
  return pace.last_state + seconds(1.0 / parameters.heartbeat_rate);
}

bool isStateDue(const Parameters& parameters, const CyclePace& pace, SteadyClock::time_point now) {
  const SteadyClock::time_point heartbeat = nextHeartbeat(parameters, pace);
  return now >= heartbeat || nextStart(parameters, pace, now) > heartbeat;
}

SteadyClock::time_point endOfWait(const Parameters& parameters, const CyclePace& pace,
                                  SteadyClock::time_point now) {
  return std::min(now + seconds(idlePeriodOf(parameters)), nextHeartbeat(parameters, pace));
}

}  // namespace collision_monitor
