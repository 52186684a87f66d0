// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/motion/speed_scale.h"

#include <algorithm>

namespace collision_monitor {

double scaleForPair(double distance, double closing_speed, const StopRule& rule) noexcept {
  if (closing_speed <= rule.rest_speed) {
    return 1.0;
  }
  const double gap = std::max(0.0, distance - rule.stop_distance);
  return std::min(1.0, gap / (closing_speed * rule.stop_time));
}

double scaleForUnknownSpeed(double distance, double slow_distance, const StopRule& rule) noexcept {
  if (distance <= rule.stop_distance) {
    return 0.0;
  }
  const double zone = slow_distance - rule.stop_distance;
  return zone > 0.0 ? std::min(1.0, (distance - rule.stop_distance) / zone) : 1.0;
}

double releasedScale(double before, double wanted, double duration, const StopRule& rule) noexcept {
  return std::min(wanted, before + std::max(0.0, duration) / rule.release_time);
}

}  // namespace collision_monitor
