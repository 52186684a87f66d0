// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/inputs/clock_feed.h"

#include <rosgraph_msgs/Clock.h>

namespace collision_monitor {

ClockFeed::ClockFeed(ros::NodeHandle node, ClockWatch& watch) {
  if (!ros::Time::isSimTime()) {
    return;
  }
  node.setCallbackQueue(&queue_);
  const boost::function<void(const rosgraph_msgs::ClockConstPtr&)> callback =
      [&watch](const rosgraph_msgs::ClockConstPtr& /*message*/) { watch.hear(SteadyClock::now()); };
  subscriber_ = node.subscribe<rosgraph_msgs::Clock>("/clock", 1, callback, ros::VoidConstPtr(),
                                                     ros::TransportHints().tcpNoDelay());
}

}  // namespace collision_monitor
