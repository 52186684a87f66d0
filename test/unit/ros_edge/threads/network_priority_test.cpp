// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/threads/network_priority.h"

#include <gtest/gtest.h>
#include <sched.h>

#include <atomic>
#include <chrono>
#include <optional>
#include <thread>

#include "ros_edge/threads/real_time.h"

namespace collision_monitor {
namespace {

/// roscpp's network thread, which reports its priority.
class NetworkThread : public testing::Test {
 protected:
  void SetUp() override {
    bool is_permitted = false;
    std::thread([&] { is_permitted = setRealTimePriority(1); }).join();
    if (!is_permitted) {
      GTEST_SKIP() << "the system does not permit real-time priority";
    }
    network_->start();
    priority_.emplace();
    // After the listener of `priority_`, in the same pass.
    reporter_ = network_->addPollThreadListener([this] {
      sched_param parameters{};
      sched_getparam(0, &parameters);
      reported_ = parameters.sched_priority;
    });
  }

  void TearDown() override { network_->shutdown(); }

  bool takes(int priority) {
    for (int i = 0; i < 1000 && reported_ != priority; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return reported_ == priority;
  }

  ros::PollManagerPtr network_ = ros::PollManager::instance();
  std::optional<NetworkPriority> priority_;
  boost::signals2::connection reporter_;
  std::atomic<int> reported_{0};
};

TEST_F(NetworkThread, takesThePriority_andHasNoneAfterTheEnd) {
  priority_->set(3);
  EXPECT_TRUE(takes(3));
  priority_->set(1);
  EXPECT_TRUE(takes(1));
  priority_.reset();
  EXPECT_TRUE(takes(0));
}

TEST_F(NetworkThread, keepsThePriorityForOneMonitorWhenAnotherEnds) {
  NetworkPriority other;
  priority_->set(2);
  other.set(2);
  EXPECT_TRUE(takes(2));
  priority_.reset();
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  EXPECT_TRUE(takes(2));
}

}  // namespace
}  // namespace collision_monitor
