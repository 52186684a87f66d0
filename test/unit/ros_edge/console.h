// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/console.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <vector>

namespace collision_monitor::test {

/// A console. It can stand still until it is released.
class Console : public ros::console::LogAppender {
 public:
  explicit Console(bool stands = false) : is_released_(!stands) {
    ros::console::register_appender(this);
  }
  ~Console() override { ros::console::deregister_appender(this); }
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  void log(ros::console::Level /*level*/, const char* text, const char* /*file*/,
           const char* /*function*/, int /*line*/) override {
    std::unique_lock<std::mutex> lock(mutex_);
    lines_.emplace_back(text);
    changed_.notify_all();
    changed_.wait(lock, [this] { return is_released_; });
  }

  void waitForFirst() {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait_for(lock, std::chrono::seconds(10), [this] { return !lines_.empty(); });
  }

  void release() {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_released_ = true;
    changed_.notify_all();
  }

  /// @pre nothing logs any more
  const std::vector<std::string>& lines() const { return lines_; }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::string> lines_;
  bool is_released_;
};

}  // namespace collision_monitor::test
