// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/inputs/inputs.h"

namespace collision_monitor {

ClockState lookAtClock(const Inputs& inputs, const ros::Time& time) {
  const std::uint64_t later = inputs.transforms.version().later + inputs.joints.laterCount();
  return inputs.clock.look(time, later, SteadyClock::now());
}

}  // namespace collision_monitor
