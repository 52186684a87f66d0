// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/inputs/clock_watch.h"

#include <gtest/gtest.h>

namespace collision_monitor {
namespace {

class ClockWatchTest : public ::testing::Test {
 protected:
  static SteadyClock::time_point at(double seconds) {
    return SteadyClock::time_point() + std::chrono::duration_cast<SteadyClock::duration>(
                                           std::chrono::duration<double>(seconds));
  }
  ClockFault lookAt(double wall, double time) {
    return watch_.look(ros::Time(time), later_data_, at(wall)).fault;
  }

  ClockWatch watch_{true, at(0.0)};
  std::uint64_t later_data_{0};
};

TEST_F(ClockWatchTest, silentLongerThanTheTimeout_dead) {
  watch_.hear(at(1.0));
  EXPECT_EQ(lookAt(1.0, 10.0), ClockFault::none);
  EXPECT_EQ(lookAt(2.0, 10.0), ClockFault::none);
  EXPECT_EQ(lookAt(2.1, 10.0), ClockFault::silent);
  EXPECT_NEAR(watch_.look(ros::Time(10.0), 0, at(3.0)).stood_for, 2.0, 1e-9);
}

TEST_F(ClockWatchTest, timeGoesOnAgain_lives) {
  lookAt(1.0, 10.0);
  ASSERT_EQ(lookAt(5.0, 10.0), ClockFault::silent);
  EXPECT_EQ(lookAt(5.1, 10.1), ClockFault::none);
}

TEST_F(ClockWatchTest, allowedToStandLonger_livesLonger) {
  watch_.allow(5.0);
  lookAt(1.0, 10.0);
  EXPECT_EQ(lookAt(5.9, 10.0), ClockFault::none);
  EXPECT_EQ(lookAt(6.1, 10.0), ClockFault::silent);
}

TEST_F(ClockWatchTest, repeatsItsTime_isPausedAndLives) {
  lookAt(1.0, 10.0);
  for (double wall = 1.0; wall < 20.0; wall += 0.5) {
    watch_.hear(at(wall));
    EXPECT_EQ(lookAt(wall, 10.0), ClockFault::none);
  }
}

TEST_F(ClockWatchTest, repeatsItsTimeAndDataGoOn_isNoPause) {
  lookAt(1.0, 10.0);
  watch_.hear(at(1.5));
  ++later_data_;  // was on its way when the clock stopped
  EXPECT_EQ(lookAt(1.5, 10.0), ClockFault::none);
  watch_.hear(at(3.0));
  EXPECT_EQ(lookAt(3.0, 10.0), ClockFault::none);
  ++later_data_;
  EXPECT_EQ(lookAt(3.1, 10.0), ClockFault::data_pass_it);
}

TEST_F(ClockWatchTest, clockOfTheMachineOrNotStarted_noFault) {
  ClockWatch of_machine(false, at(0.0));
  of_machine.look(ros::Time(10.0), 0, at(1.0));
  EXPECT_EQ(of_machine.look(ros::Time(10.0), 0, at(9.0)).fault, ClockFault::none);
  EXPECT_EQ(lookAt(9.0, 0.0), ClockFault::none);
}

}  // namespace
}  // namespace collision_monitor
