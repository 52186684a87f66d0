// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/kinematics/joint_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace collision_monitor {
namespace {

/// One joint, variable 1 of 2, by way-points at 2 s, 4 s and 5 s.
class JointPathTest : public testing::Test {
 protected:
  JointPathTest() {
    model_.variable_count = 2;
    model_.joints.resize(2);
    model_.joints[1].first_variable = 1;
    path_.joints = {idAt<JointId>(1)};
    path_.times = {2.0, 4.0, 5.0};
    path_.positions = {1.0, 3.0, -1.0};
  }
  double positionAt(std::size_t segment, double share) {
    JointPositions positions{77.0, 0.0};
    setPositions(model_, path_, segment, share, positions);
    EXPECT_EQ(positions[0], 77.0) << "the other variable is left alone";
    return positions[1];
  }

  RobotModel model_;
  JointPath path_;
};

TEST_F(JointPathTest, withoutVelocities_linear) {
  EXPECT_EQ(positionAt(0, 0.0), 1.0);
  EXPECT_NEAR(positionAt(0, 0.25), 1.5, 1e-15);
  EXPECT_EQ(positionAt(1, 1.0), -1.0);
  EXPECT_EQ(positionAt(2, 0.0), -1.0);
  EXPECT_NEAR(timeAt(path_, 0, 0.25), 2.5, 1e-15);
  EXPECT_EQ(timeAt(path_, 1, 1.0), 5.0);
  EXPECT_NEAR(travelOf(path_, {1, 0.25, 0.5}, 0), 1.0, 1e-15);
}

TEST_F(JointPathTest, withVelocities_cubic) {
  // From rest to rest: 3 s^2 - 2 s^3 of the way, a half in the middle.
  path_.velocities = {0.0, 0.0, 0.0};
  EXPECT_NEAR(positionAt(0, 0.5), 2.0, 1e-15);
  EXPECT_NEAR(positionAt(0, 0.25), 1.0 + 2.0 * (3.0 / 16.0 - 2.0 / 64.0), 1e-15);
  EXPECT_NEAR(travelOf(path_, {0, 0.0, 1.0}, 0), 2.0, 1e-15);
}

TEST_F(JointPathTest, cubicThatTurnsBack_wayThereAndBack) {
  // From 1 to 1 in 2 s, leaving at 1 m/s and coming back at 1 m/s: s (1 - s) * 2, half a metre up.
  path_.positions = {1.0, 1.0, 1.0};
  path_.velocities = {1.0, -1.0, 0.0};
  EXPECT_NEAR(positionAt(0, 0.5), 1.5, 1e-15);
  EXPECT_NEAR(travelOf(path_, {0, 0.0, 1.0}, 0), 1.0, 1e-12);
  EXPECT_NEAR(travelOf(path_, {0, 0.25, 0.75}, 0), 0.25, 1e-12);
  EXPECT_NEAR(travelOf(path_, {0, 0.5, 1.0}, 0), 0.5, 1e-12);
}

TEST_F(JointPathTest, cubicWithTwoTurns_allThreeWays) {
  // 3 s - 9 s^2 + 6 s^3: turns where 3 - 18 s + 18 s^2 = 0, s = (3 -+ sqrt(3)) / 6, by
  // 1 / sqrt(12) either side of the middle, where it is 0.
  path_.times = {0.0, 1.0};
  path_.positions = {0.0, 0.0};
  path_.velocities = {3.0, 3.0};
  EXPECT_NEAR(positionAt(0, (3.0 - std::sqrt(3.0)) / 6.0), 1.0 / std::sqrt(12.0), 1e-12);
  EXPECT_NEAR(travelOf(path_, {0, 0.0, 1.0}, 0), 4.0 / std::sqrt(12.0), 1e-12);
}

TEST_F(JointPathTest, aLinearPart_isItsStep) {
  const JointStep step = stepOf(path_, {1, 0.25, 0.75}, 0);
  EXPECT_NEAR(step.half, -1.0, 1e-15);
  EXPECT_NEAR(step.bend, 0.0, 1e-15);
}

TEST_F(JointPathTest, severalSegments_bendByTheirCorners) {
  // From 1 by 3 to -1, about 3: a line through 3 that falls by 1 each passes 4 and 2.
  const JointStep step = stepOf(path_, 0, 1, 2, 0);
  EXPECT_NEAR(step.half, -1.0, 1e-15);
  EXPECT_NEAR(step.bend, 3.0, 1e-15);
}

/// The true path is sampled: it leaves its step by the bend at most, and by not much less.
TEST_F(JointPathTest, cubics_leaveTheirStepByTheBend) {
  path_.velocities = {2.0, -1.0, 3.0};
  const auto most_off = [&](double from, double to) {
    const JointStep step = stepOf(path_, {0, from, to}, 0);
    double most = 0.0;
    for (double s = -1.0; s <= 1.0; s += 0.125) {
      const double share = 0.5 * (from + to) + 0.5 * s * (to - from);
      const double middle = positionAt(0, 0.5 * (from + to));
      most = std::max(most, std::abs(positionAt(0, share) - middle - s * step.half));
    }
    EXPECT_LE(most, step.bend + 1e-12);
    return most / step.bend;
  };
  EXPECT_GT(most_off(0.0, 1.0), 0.5);
  EXPECT_GT(most_off(0.25, 0.5), 0.5);
  const JointStep both = stepOf(path_, 0, 1, 2, 0);
  for (double share = 0.0; share <= 1.0; share += 0.125) {
    EXPECT_LE(std::abs(positionAt(0, share) - 3.0 - (share - 1.0) * both.half), both.bend);
    EXPECT_LE(std::abs(positionAt(1, share) - 3.0 - share * both.half), both.bend);
  }
}

TEST_F(JointPathTest, whatIsNotSound) {
  EXPECT_TRUE(isSound(path_));
  JointPath path = path_;
  path.positions[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(isSound(path));
  path = path_;
  path.times[2] = 4.0;
  EXPECT_FALSE(isSound(path)) << "time stands still";
  path = path_;
  path.positions.pop_back();
  EXPECT_FALSE(isSound(path));
  path = path_;
  path.velocities = {0.0};
  EXPECT_FALSE(isSound(path));
  EXPECT_FALSE(isSound(JointPath()));
}

}  // namespace
}  // namespace collision_monitor
