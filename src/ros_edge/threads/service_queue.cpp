// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/threads/service_queue.h"

#include <sys/resource.h>

#include <utility>

#include "ros_edge/threads/real_time.h"

namespace collision_monitor {
namespace {

thread_local bool is_hurrying = false;

}  // namespace

ServiceQueue::ServiceQueue(int threads, int nicer, std::function<int()> priority)
    : priority_(std::move(priority)) {
  for (int i = 0; i < threads; ++i) {
    threads_.emplace_back([this, nicer] { run(nicer); });
  }
}

ServiceQueue::~ServiceQueue() {
  end();
  for (std::thread& thread : threads_) {
    thread.join();
  }
}

void ServiceQueue::hurry() noexcept {
  const int priority = priority_();
  is_hurrying = priority > 0 && setRealTimePriority(priority);
}

void ServiceQueue::run(int nicer) {
  // On Linux this sets the nice value of the calling thread only.
  setpriority(PRIO_PROCESS, 0, getpriority(PRIO_PROCESS, 0) + nicer);
  while (!is_ending_) {
    constexpr double kWait = 0.1;  // [s] longest delay until the end is noticed
    queue_.callOne(ros::WallDuration(kWait));
    if (std::exchange(is_hurrying, false)) {
      setRealTimePriority(0);
    }
  }
}

}  // namespace collision_monitor
