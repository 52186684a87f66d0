// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include "ros_edge/threads/inheriting_mutex.h"

namespace collision_monitor {

/// On, or off until a given time. By steady time: a clock that jumps must not keep a monitor off.
/// Safe for several threads.
class Enabling {
 public:
  void switchOn();
  /// Units: seconds.
  void switchOffFor(double duration);
  bool isOn(const ros::SteadyTime& now) const;
  /// [s] 0 while on.
  double secondsUntilOn(const ros::SteadyTime& now) const;

 private:
  mutable InheritingMutex mutex_;
  ros::SteadyTime off_until_;
};

}  // namespace collision_monitor
