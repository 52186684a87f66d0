// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace collision_monitor {

/// Looks on its own thread, twice a second by wall time, whether robots that are missing have come.
class LateRobots {
 public:
  /// @param is_any_missing is asked first
  /// @param take_in takes in those that have come, if there are any; may throw: it is then called
  /// again, and each reason is logged once
  LateRobots(std::function<bool()> is_any_missing, std::function<void()> take_in);
  ~LateRobots();
  LateRobots(const LateRobots&) = delete;
  LateRobots& operator=(const LateRobots&) = delete;

 private:
  void run();
  void look();

  std::function<bool()> is_any_missing_;
  std::function<void()> take_in_;
  std::string told_;  ///< why they could not be taken in, as last logged
  std::mutex mutex_;  ///< guards the next two
  std::condition_variable woken_;
  bool is_ending_{false};
  std::thread thread_;
};

}  // namespace collision_monitor
