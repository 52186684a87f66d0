// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "collision_monitor/pipeline/run_cycle.h"
#include "collision_monitor/ros_edge/pose_reader.h"
#include "ros_edge/monitor_setup.h"

namespace collision_monitor {

/// One set-up and what changes while it is watched. Belongs to the thread of the cycle.
struct Watch {
  Watch(std::shared_ptr<const MonitorSetup> fixed_parts, const TransformStore& store);

  std::shared_ptr<const MonitorSetup> fixed;
  PoseReader reader;
  LinkPoses poses;
  CycleBuffers buffers;

  const CycleSetup& setup() const noexcept { return fixed->setup; }
};

/// What messages say beside the result of the cycle.
struct CycleFacts {
  ros::Time now;
  bool is_enabled{true};
  double enabled_again_in{0.0};  ///< [s] while switched off
  std::uint64_t cycles{0};
  std::uint64_t overruns{0};
  double cycle_time{0.0};  ///< [s]
};

/// The broad phase a set-up gets when none is asked for. Below some hundred pairs a pass over the
/// list costs less than keeping end points sorted.
BroadPhaseKind chooseBroadPhase(const CycleSetup& setup) noexcept;

/// Links with geometry whose pose is unknown, into `links`.
void findUnknownLinks(const Watch& watch, std::vector<LinkId>& links);

}  // namespace collision_monitor
