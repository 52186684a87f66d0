// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/poll_manager.h>

#include <atomic>

namespace collision_monitor {

/// The real-time priority of roscpp's network thread, which stores messages and sends them. Cycles
/// need locks that it holds: if other threads delay it, they delay the cycle.
class NetworkPriority {
 public:
  NetworkPriority();
  /// Waits until the thread has its former priority, at most a second; not if ROS has shut down.
  ~NetworkPriority();
  NetworkPriority(const NetworkPriority&) = delete;
  NetworkPriority& operator=(const NetworkPriority&) = delete;

  /// The thread takes it with the next message, or within 0.1 s. Any thread may call it.
  /// @param priority 1 to 99 for SCHED_FIFO; 0: none
  void set(int priority) noexcept { wanted_ = priority; }
  /// What was set last. Any thread may call it.
  int wanted() const noexcept { return wanted_; }

 private:
  void apply() noexcept;

  std::atomic<int> wanted_{0};
  std::atomic<int> given_{0};  ///< what the thread has asked for
  int seen_resets_{0};         ///< by any monitor of this process; used by the thread only
  boost::signals2::connection listener_;
};

}  // namespace collision_monitor
