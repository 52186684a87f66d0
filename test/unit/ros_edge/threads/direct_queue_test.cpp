// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/threads/direct_queue.h"

#include <gtest/gtest.h>

#include <atomic>
#include <boost/make_shared.hpp>
#include <mutex>
#include <thread>

namespace collision_monitor::test {
namespace {

/// Like roscpp's queue of a subscription, refuses to run while it runs.
class Counter : public ros::CallbackInterface {
 public:
  CallResult call() override {
    std::unique_lock<std::mutex> lock(running_, std::try_to_lock);
    if (!lock.owns_lock()) {
      ++refused_;
      return TryAgain;
    }
    ++calls_;
    std::this_thread::yield();
    return Success;
  }

  int calls() const { return calls_; }
  int refused() const { return refused_; }

 private:
  std::mutex running_;
  std::atomic<int> calls_{0};
  std::atomic<int> refused_{0};
};

TEST(DirectQueue, callback_hasRunWhenAdded) {
  DirectQueue queue;
  const auto counter = boost::make_shared<Counter>();
  queue.addCallback(counter, 1);
  EXPECT_EQ(counter->calls(), 1);
  queue.removeByID(1);
  EXPECT_EQ(counter->calls(), 1);
}

TEST(DirectQueue, fromTwoThreads_losesNothing) {
  constexpr int kEach = 20000;
  DirectQueue queue;
  const auto counter = boost::make_shared<Counter>();
  const auto add = [&] {
    for (int i = 0; i < kEach; ++i) {
      queue.addCallback(counter, 1);
    }
  };
  std::thread other(add);
  add();
  other.join();
  EXPECT_EQ(counter->calls(), 2 * kEach);
  EXPECT_EQ(counter->refused(), 0);
}

}  // namespace
}  // namespace collision_monitor::test
