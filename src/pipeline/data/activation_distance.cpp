// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/data/activation_distance.h"

#include <algorithm>

namespace collision_monitor {

double activationDistanceOf(const Limits& limits) noexcept {
  return std::max(limits.report_distance, limits.warning_distance + limits.hysteresis);
}

double nearActivationDistanceOf(const CycleSetup& setup) noexcept {
  return std::max(setup.refine.distance, setup.limits.warning_distance + setup.limits.hysteresis);
}

}  // namespace collision_monitor
