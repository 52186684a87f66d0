// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/motion/speed_scale.h"

#include <gtest/gtest.h>

namespace collision_monitor {
namespace {

/// stop_distance, stop_time, release_time, rest_speed, creep_scale
constexpr StopRule kRule{0.01, 0.25, 0.5, 0.002, 0.0};

TEST(ScaleForPair, closing_isWhatReachesTheStopDistanceInTheStopTime) {
  // 40 mm are left; in 0.25 s that is 0.16 m/s, and it closes at 0.2.
  EXPECT_DOUBLE_EQ(scaleForPair(0.05, 0.2, kRule), 0.8);
  EXPECT_DOUBLE_EQ(scaleForPair(0.05, 0.16, kRule), 1.0);
  EXPECT_DOUBLE_EQ(scaleForPair(0.05, 0.1, kRule), 1.0);
}

TEST(ScaleForPair, atStopDistance_isZero) {
  EXPECT_EQ(scaleForPair(0.01, 0.003, kRule), 0.0);
  EXPECT_EQ(scaleForPair(-0.02, 0.003, kRule), 0.0);
}

TEST(ScaleForPair, partingAndResting_isFree) {
  EXPECT_EQ(scaleForPair(0.005, -0.2, kRule), 1.0);
  EXPECT_EQ(scaleForPair(-0.02, -0.2, kRule), 1.0);
  EXPECT_EQ(scaleForPair(0.005, 0.0019, kRule), 1.0);
}

TEST(ScaleForUnknownSpeed, goesByDistance) {
  EXPECT_DOUBLE_EQ(scaleForUnknownSpeed(0.05, 0.05, kRule), 1.0);
  EXPECT_DOUBLE_EQ(scaleForUnknownSpeed(0.03, 0.05, kRule), 0.5);
  EXPECT_DOUBLE_EQ(scaleForUnknownSpeed(0.01, 0.05, kRule), 0.0);
  EXPECT_DOUBLE_EQ(scaleForUnknownSpeed(0.02, 0.0, kRule), 1.0) << "no zone to slow down in";
}

TEST(ReleasedScale, fallsAtOnceAndGrowsSlowly) {
  EXPECT_DOUBLE_EQ(releasedScale(1.0, 0.1, 0.01, kRule), 0.1);
  EXPECT_DOUBLE_EQ(releasedScale(0.1, 1.0, 0.05, kRule), 0.2);
  EXPECT_DOUBLE_EQ(releasedScale(0.1, 0.15, 0.05, kRule), 0.15);
  EXPECT_DOUBLE_EQ(releasedScale(0.1, 1.0, -3.0, kRule), 0.1) << "time that jumped back";
}

}  // namespace
}  // namespace collision_monitor
