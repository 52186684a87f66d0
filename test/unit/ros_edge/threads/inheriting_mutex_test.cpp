// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/threads/inheriting_mutex.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <thread>

#include "ros_edge/threads/real_time.h"

namespace collision_monitor {
namespace {

/// The priority that the calling thread has now, below 0 for one in real time. It is the 18th field
/// of `stat`; the second ends with the only ')'.
int priorityNow() {
  std::ifstream file("/proc/thread-self/stat");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  std::istringstream fields(text.substr(text.rfind(')') + 1));
  std::string skipped;
  for (int field = 3; field < 18; ++field) {
    fields >> skipped;
  }
  int priority = 0;
  fields >> priority;
  return priority;
}

/// @return whether a thread that holds the mutex comes to have real-time priority, because one that
/// has it waits; false if the system does not permit it
bool inheritsFromWaiter(std::mutex& mutex, std::atomic<bool>& is_permitted) {
  mutex.lock();
  std::thread waiter([&] {
    is_permitted = setRealTimePriority(2);
    mutex.lock();
    mutex.unlock();
  });
  bool inherits = false;
  for (int i = 0; i < 200 && !inherits; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    inherits = priorityNow() < 0;
  }
  mutex.unlock();
  waiter.join();
  return inherits;
}

TEST(InheritingMutex, itsHolder_hasThePriorityOfWhoWaits) {
  std::atomic<bool> is_permitted{false};
  std::mutex plain;
  EXPECT_FALSE(inheritsFromWaiter(plain, is_permitted));
  if (!is_permitted) {
    GTEST_SKIP() << "the system does not permit real-time priority";
  }
  InheritingMutex mutex;
  EXPECT_TRUE(inheritsFromWaiter(mutex, is_permitted));
  EXPECT_GE(priorityNow(), 0) << "and gives it back";
}

}  // namespace
}  // namespace collision_monitor
