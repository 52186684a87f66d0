// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/threads/woken_thread.h"

#include <boost/interprocess/exceptions.hpp>
#include <utility>

namespace collision_monitor {

WokenThread::WokenThread(std::function<void()> work)
    : work_(std::move(work)), thread_([this] { run(); }) {}

WokenThread::~WokenThread() {
  is_ending_ = true;
  try {
    wake();
  } catch (const boost::interprocess::interprocess_exception&) {
    // More wakes wait than can be counted: the thread comes to see that it ends.
  }
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
