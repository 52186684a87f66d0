// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/ros_edge/joint_store.h"
#include "collision_monitor/ros_edge/transform_store.h"
#include "ros_edge/clock_watch.h"

namespace collision_monitor {

/// Where poses, joint states and the time come from.
struct Inputs {
  TransformStore& transforms;
  JointStore& joints;
  ClockWatch& clock;
};

/// Whether the clock can be believed now, for the time that it told.
ClockState lookAtClock(const Inputs& inputs, const ros::Time& time);

}  // namespace collision_monitor
