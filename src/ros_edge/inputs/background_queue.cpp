// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/inputs/background_queue.h"

#include <sys/resource.h>

namespace collision_monitor {

BackgroundQueue::BackgroundQueue() {
  thread_ = std::thread([this] { run(); });
}

BackgroundQueue::~BackgroundQueue() {
  end();
  thread_.join();
}

void BackgroundQueue::run() {
  // On Linux this sets the nice value of the calling thread only, up to the maximum. The thread
  // gets a tenth of a normal thread's processor time if both want it, otherwise all that is free.
  constexpr int kNicer = 10;
  setpriority(PRIO_PROCESS, 0, getpriority(PRIO_PROCESS, 0) + kNicer);
  while (!is_ending_) {
    constexpr double kWait = 0.1;  // [s] longest delay until the end is noticed
    queue_.callOne(ros::WallDuration(kWait));
  }
}

}  // namespace collision_monitor
