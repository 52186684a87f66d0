// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/data/activation_distance.h"

#include <algorithm>

namespace collision_monitor {

double activationDistanceOf(const Limits& limits) noexcept {
  return std::max(limits.report_distance, limits.warning_distance + limits.hysteresis);
}

double nearActivationDistanceOf(const CycleSetup& setup, const Limits& limits) noexcept {
  return std::max(setup.refine.distance, limits.warning_distance + limits.hysteresis);
}

double farthestActivationDistanceOf(const CycleSetup& setup) noexcept {
  return largestOfLimits(setup, [&](const Limits& limits) noexcept {
    return std::max({activationDistanceOf(limits), nearActivationDistanceOf(setup, limits),
                     setup.ahead.stop.stop_distance + limits.hysteresis});
  });
}

double leastActivationDistanceOf(const CycleSetup& setup) noexcept {
  return -largestOfLimits(
      setup, [](const Limits& limits) noexcept { return -activationDistanceOf(limits); });
}

}  // namespace collision_monitor
