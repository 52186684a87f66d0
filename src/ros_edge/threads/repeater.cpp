// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/threads/repeater.h"

#include <utility>

namespace collision_monitor {

Repeater::Repeater(std::chrono::milliseconds pause, std::function<void()> call)
    : call_(std::move(call)) {
  thread_ = std::thread([this, pause] { run(pause); });
}

Repeater::~Repeater() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_ending_ = true;
  }
  woken_.notify_all();
  thread_.join();
}

void Repeater::run(std::chrono::milliseconds pause) {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!woken_.wait_for(lock, pause, [this] { return is_ending_; })) {
    lock.unlock();
    call_();
    lock.lock();
  }
}

}  // namespace collision_monitor
