// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/threads/real_time.h"

#include <gtest/gtest.h>
#include <sched.h>

#include <functional>
#include <thread>
#include <utility>

namespace collision_monitor {
namespace {

/// (policy, priority) of the calling thread.
std::pair<int, int> scheduling() {
  sched_param parameters{};
  sched_getparam(0, &parameters);
  return {sched_getscheduler(0) & ~SCHED_RESET_ON_FORK, parameters.sched_priority};
}

const std::pair<int, int> kNormal{SCHED_OTHER, 0};

/// On a thread of its own, so that other tests keep their priority.
void onThread(const std::function<void(RealTime&)>& work) {
  std::thread([&] {
    RealTime real_time;
    work(real_time);
  }).join();
}

bool isPermitted() {
  RealTimeState state{};
  onThread([&](RealTime& real_time) {
    real_time.set(1);
    state = real_time.state();
  });
  return state == RealTimeState::on;
}

/// Containers and users without the right cannot try these.
class PermittedRealTime : public testing::Test {
 protected:
  void SetUp() override {
    if (!isPermitted()) {
      GTEST_SKIP() << "the system does not permit real-time priority";
    }
  }
};

TEST(RealTime, askedFor_onOrRefusedAndThreadsAreAsTheStateSays) {
  onThread([](RealTime& real_time) {
    EXPECT_EQ(real_time.state(), RealTimeState::off);
    real_time.set(2);
    const bool is_on = real_time.state() == RealTimeState::on;
    EXPECT_EQ(scheduling(), is_on ? std::pair(SCHED_FIFO, 2) : kNormal);
    EXPECT_TRUE(is_on || real_time.state() == RealTimeState::refused);
    real_time.set(0);
    EXPECT_EQ(real_time.state(), RealTimeState::off);
    EXPECT_EQ(scheduling(), kNormal);
  });
}

TEST_F(PermittedRealTime, setAgainAndAgain_lateCyclesCountOn) {
  onThread([](RealTime& real_time) {
    for (int i = 0; i < 100; ++i) {
      real_time.set(1);
      real_time.add(true);
    }
    EXPECT_EQ(real_time.state(), RealTimeState::given_up);
  });
}

TEST_F(PermittedRealTime, threadsThatItsThreadStarts_doNotInheritIt) {
  onThread([](RealTime& real_time) {
    real_time.set(1);
    std::thread([] { EXPECT_EQ(scheduling(), kNormal); }).join();
  });
}

TEST_F(PermittedRealTime, aPriorityThatIsRefused_leavesNone) {
  onThread([](RealTime& real_time) {
    real_time.set(1);
    real_time.set(1000);
    EXPECT_EQ(real_time.state(), RealTimeState::refused);
    EXPECT_EQ(scheduling(), kNormal);
  });
}

TEST_F(PermittedRealTime, manyLateCyclesInARow_giveItUpUntilItIsSetAgain) {
  onThread([](RealTime& real_time) {
    real_time.set(1);
    for (int i = 0; i < 1000; ++i) {
      real_time.add(i % 100 != 99);
    }
    EXPECT_EQ(real_time.state(), RealTimeState::on) << "never 100 late ones in a row";
    for (int i = 0; i < 100; ++i) {
      real_time.add(true);
    }
    EXPECT_EQ(real_time.state(), RealTimeState::given_up);
    EXPECT_EQ(scheduling(), kNormal);
    real_time.set(1);
    EXPECT_EQ(real_time.state(), RealTimeState::given_up) << "cycles are late still";
    real_time.add(false);
    real_time.set(1);
    EXPECT_EQ(real_time.state(), RealTimeState::on);
    EXPECT_EQ(scheduling(), std::pair(SCHED_FIFO, 1));
  });
}

TEST_F(PermittedRealTime, manyCyclesInTime_bringItBack) {
  onThread([](RealTime& real_time) {
    real_time.set(1);
    for (int i = 0; i < 100; ++i) {
      real_time.add(true);
    }
    for (int i = 0; i < 999; ++i) {
      real_time.add(false);
    }
    EXPECT_EQ(real_time.state(), RealTimeState::given_up);
    real_time.add(false);
    EXPECT_EQ(real_time.state(), RealTimeState::on);
    EXPECT_EQ(scheduling(), std::pair(SCHED_FIFO, 1));
  });
}

}  // namespace
}  // namespace collision_monitor
