// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/threads/log_thread.h"

#include <gtest/gtest.h>
#include <ros/console.h>

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace collision_monitor {
namespace {

/// A console that stands still until it is released.
class StandingConsole : public ros::console::LogAppender {
 public:
  StandingConsole() { ros::console::register_appender(this); }
  ~StandingConsole() override { ros::console::deregister_appender(this); }
  StandingConsole(const StandingConsole&) = delete;
  StandingConsole& operator=(const StandingConsole&) = delete;

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
  bool is_released_{false};
};

TEST(LogThread, whileTheConsoleStands_nobodyWaitsAndTheFirstLinesAreKept) {
  constexpr std::size_t kMany = 3000;
  StandingConsole console;
  {
    LogThread log;
    log.warn("first");
    console.waitForFirst();
    for (std::size_t i = 0; i < kMany; ++i) {
      log.info("line " + std::to_string(i));
    }
    console.release();
  }  // waits for all lines
  const std::vector<std::string>& lines = console.lines();
  ASSERT_GT(lines.size(), 2U);
  EXPECT_EQ(lines.front(), "first");
  const std::size_t kept = lines.size() - 2;
  for (std::size_t i = 0; i < kept; ++i) {
    EXPECT_EQ(lines[1 + i], "line " + std::to_string(i));
  }
  EXPECT_LT(kept, kMany);
  EXPECT_EQ(lines.back(), "the log is too slow: lines left out: " + std::to_string(kMany - kept));
}

}  // namespace
}  // namespace collision_monitor
