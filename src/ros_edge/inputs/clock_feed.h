// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/subscriber.h>

#include "ros_edge/inputs/clock_watch.h"
#include "ros_edge/threads/direct_queue.h"

namespace collision_monitor {

/// Reports each message of /clock to a watch. roscpp sets the time by them, but tells nobody of
/// messages that repeat it. Does nothing if time is not simulated. Ends with this object.
class ClockFeed {
 public:
  /// @pre `watch` outlives the feed
  ClockFeed(ros::NodeHandle node, ClockWatch& watch);

 private:
  DirectQueue queue_;  ///< outlives the subscriber
  ros::Subscriber subscriber_;
};

}  // namespace collision_monitor
