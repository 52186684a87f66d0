// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/subscriber.h>

#include "ros_edge/direct_queue.h"
#include "ros_edge/inputs/clock_watch.h"

namespace collision_monitor {

/// Tells a watch of each message of /clock: roscpp sets the time by them and tells nobody of those
/// that repeat it. Hears nothing where time is not simulated. Stops with its life.
class ClockFeed {
 public:
  /// @pre `watch` outlives the feed
  ClockFeed(ros::NodeHandle node, ClockWatch& watch);

 private:
  DirectQueue queue_;  ///< ends after the subscriber
  ros::Subscriber subscriber_;
};

}  // namespace collision_monitor
