// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/threads/woken_thread.h"

#include <utility>

namespace collision_monitor {

WokenThread::WokenThread(std::function<void()> work)
    : work_(std::move(work)), thread_([this] { run(); }) {}

WokenThread::~WokenThread() {
  is_ending_ = true;
  wake();
  thread_.join();
}

void WokenThread::run() {
  bool is_last = false;
  while (!is_last) {
    woken_.wait();
    is_last = is_ending_;
    work_();
  }
}

}  // namespace collision_monitor
