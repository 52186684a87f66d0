// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/look_ahead/find_closings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "geometry/constants.h"
#include "unit/pipeline/cycle/two_balls.h"

namespace collision_monitor::test {
namespace {

class FindClosings : public TwoBalls {};

TEST_F(FindClosings, closingPair_hasSpeedAndTime) {
  runWithGap(0.06, 0.2);
  EXPECT_NEAR(nearest().closing_speed, 0.2, 1e-12);
  EXPECT_NEAR(nearest().time_to_contact, 0.3, 1e-12);
  EXPECT_NEAR(buffers_.events.time_to_contact, 0.3, 1e-12);
  EXPECT_EQ(buffers_.events.soonest[0], 0U);
  EXPECT_EQ(verdict(), Verdict::clear);
}

TEST_F(FindClosings, partingPair_neverMeets) {
  runWithGap(0.06, -0.2);
  EXPECT_NEAR(nearest().closing_speed, -0.2, 1e-12);
  EXPECT_EQ(nearest().time_to_contact, kInfinity);
  EXPECT_EQ(buffers_.events.time_to_contact, kInfinity);
  EXPECT_EQ(buffers_.events.soonest[0], kNone);
}

TEST_F(FindClosings, overlappingPair_isInContactNow) {
  runWithGap(-0.02, -0.3);
  EXPECT_EQ(nearest().time_to_contact, 0.0);
  EXPECT_NEAR(nearest().closing_speed, -0.3, 1e-12);
}

TEST_F(FindClosings, velocityNotKnown_leavesVerdictsToTheDistance) {
  runWithGap(0.06, 5.0);
  poses_.velocities.known[1] = 0;
  runCycle(setup_, poses_, buffers_);
  EXPECT_TRUE(std::isnan(nearest().closing_speed));
  EXPECT_TRUE(std::isnan(nearest().time_to_contact));
  EXPECT_TRUE(std::isnan(buffers_.events.time_to_contact));
  poses_.velocities.known[1] = 1;
  poses_.velocities.of_link[1].linear.x() = std::numeric_limits<double>::quiet_NaN();
  resetMemory(buffers_);
  runCycle(setup_, poses_, buffers_);
  EXPECT_TRUE(std::isnan(nearest().closing_speed));
  EXPECT_EQ(verdict(), Verdict::clear);
}

TEST_F(FindClosings, depthThatIsAllowed_isAGapToo) {
  PairDistances distances;
  distances.pairs.resize(1);
  distances.pairs[0].measured = {-0.01, {0.1, 0, 0}, {0.09, 0, 0}, Eigen::Vector3d::UnitX()};
  setVelocity(0, 0.25);
  setVelocity(1, 0.15);
  setup_.limits.contact_distance = -0.04;
  findClosings(setup_, poses_, distances);
  EXPECT_NEAR(distances.pairs[0].closing_speed, 0.1, 1e-15);
  EXPECT_NEAR(distances.pairs[0].time_to_contact, 0.3, 1e-12) << "0.03 m at 0.1 m/s";
}

}  // namespace
}  // namespace collision_monitor::test
