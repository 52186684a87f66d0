// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ros_edge/inputs/clock_watch.h"
#include "ros_edge/poses/joint_store.h"
#include "ros_edge/poses/transform_store.h"

namespace collision_monitor {

/// Sources of poses, joint states and time.
struct Inputs {
  TransformStore& transforms;
  JointStore& joints;
  ClockWatch& clock;
};

/// Whether the clock can be trusted now, given the time that it reports.
ClockState lookAtClock(const Inputs& inputs, const ros::Time& time);

}  // namespace collision_monitor
