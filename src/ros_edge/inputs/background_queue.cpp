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
  // On Linux this is the nice value of the calling thread alone, held to the greatest there is. A
  // tenth of the processor time of a usual thread where both want it, all that is left over else.
  constexpr int kNicer = 10;
  setpriority(PRIO_PROCESS, 0, getpriority(PRIO_PROCESS, 0) + kNicer);
  while (!is_ending_) {
    constexpr double kWait = 0.1;  // [s] how late the end may be seen
    queue_.callOne(ros::WallDuration(kWait));
  }
}

}  // namespace collision_monitor
