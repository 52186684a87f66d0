// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/services/enabling.h"

#include <algorithm>

namespace collision_monitor {

void Enabling::switchOn() {
  const std::lock_guard<std::mutex> lock(mutex_);
  off_until_ = ros::SteadyTime();
}

void Enabling::switchOffFor(double duration) {
  const std::lock_guard<std::mutex> lock(mutex_);
  off_until_ = ros::SteadyTime::now() + ros::WallDuration(duration);
}

bool Enabling::isOn(const ros::SteadyTime& now) const { return secondsUntilOn(now) <= 0.0; }

double Enabling::secondsUntilOn(const ros::SteadyTime& now) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return off_until_.isZero() ? 0.0 : std::max(0.0, (off_until_ - now).toSec());
}

}  // namespace collision_monitor
