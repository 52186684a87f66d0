// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "motion/closing_bound.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/fixed_seed.h"
#include "support/random_poses.h"

namespace collision_monitor::test {
namespace {

Eigen::Vector3d pointIn(const Ball& ball, Random& random) {
  const Eigen::Vector3d direction = randomPoint(random, 1.0).normalized();
  return ball.center + ball.radius * direction;
}

TEST(ClosingBound, isNotLessThanOfAnyPoints) {
  Random random(kSeed);
  double largest_share = 0.0;
  for (int i = 0; i < 2000; ++i) {
    const Ball a{randomPoint(random, 0.2), 0.1};
    const Ball b{randomPoint(random, 0.2) + Eigen::Vector3d(1.0, 0.0, 0.0), 0.2};
    const Twist twist{randomPoint(random, 1.0), randomPoint(random, 1.0)};
    const double bound = closingBound(a, b, twist);
    double fastest = -1e9;
    for (int k = 0; k < 200; ++k) {
      const Eigen::Vector3d on_a = pointIn(a, random);
      const Eigen::Vector3d on_b = pointIn(b, random);
      fastest = std::max(fastest, -(on_b - on_a).normalized().dot(velocityAt(twist, on_b)));
    }
    ASSERT_LE(fastest, bound);
    largest_share = std::max(largest_share, fastest / bound);
  }
  EXPECT_GT(largest_share, 0.9);  // and it is not much more
}

TEST(ClosingBound, bodiesThatPart_isBelowZero) {
  const Ball a{{0.0, 0.0, 0.0}, 0.1};
  const Ball b{{1.0, 0.0, 0.0}, 0.1};
  EXPECT_LT(closingBound(a, b, {{1.0, 0.0, 0.0}, Eigen::Vector3d::Zero()}), 0.0);
  EXPECT_NEAR(closingBound(a, b, {{-1.0, 0.0, 0.0}, Eigen::Vector3d::Zero()}), 1.0, 1e-12);
}

TEST(ClosingBound, ballsThatMeet_everyDirection) {
  const Ball a{{0.0, 0.0, 0.0}, 0.6};
  const Ball b{{1.0, 0.0, 0.0}, 0.6};
  EXPECT_NEAR(closingBound(a, b, {{1.0, 2.0, 2.0}, Eigen::Vector3d::Zero()}), 3.0, 1e-12);
}

}  // namespace
}  // namespace collision_monitor::test
