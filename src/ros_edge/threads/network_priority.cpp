// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/threads/network_priority.h"

#include <ros/init.h>

#include <chrono>
#include <thread>

#include "ros_edge/threads/real_time.h"

namespace collision_monitor {

NetworkPriority::NetworkPriority()
    : listener_(ros::PollManager::instance()->addPollThreadListener([this] { apply(); })) {}

NetworkPriority::~NetworkPriority() {
  constexpr int kMost = 1000;  // the thread may be stuck
  wanted_ = 0;
  for (int i = 0; i < kMost && given_ != 0 && !ros::isShuttingDown(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  ros::PollManager::instance()->removePollThreadListener(listener_);
}

void NetworkPriority::apply() noexcept {
  static int resets = 0;  // another monitor of this nodelet manager may have ended
  const int wanted = wanted_;
  if (wanted != given_ || (wanted != 0 && seen_resets_ != resets)) {
    setRealTimePriority(wanted);
    resets += wanted == 0 ? 1 : 0;
    seen_resets_ = resets;
    given_ = wanted;
  }
}

}  // namespace collision_monitor
