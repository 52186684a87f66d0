// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "geometry/point_triangle.h"
#include "support/fixed_seed.h"
#include "support/random_poses.h"

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

constexpr int kCases = 200000;

double anyPowerOfTen(Random& random, double low, double high) {
  return std::pow(10.0, uniform(random, low, high));
}

/// Needles of every thinness down to none, where areas are mostly rounding.
TEST(PointTriangleLaws, noPointOfANeedleIsNearerThanTheClosest) {
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  Random random(kSeed);
  for (int i = 0; i < kCases; ++i) {
    const double size = anyPowerOfTen(random, -3.0, 1.0);
    const Vector3d a = randomPoint(random, size);
    const Vector3d b = a + randomPoint(random, size);
    const Vector3d c = a + uniform(random, 0.0, 1.0) * (b - a) +
                       randomPoint(random, size * anyPowerOfTen(random, -16.0, -1.0));
    const double u = uniform(random, 0.0, 1.0);
    const double v = uniform(random, 0.0, 1.0 - u);
    const Vector3d inside = a + u * (b - a) + v * (c - a);
    const Vector3d across = (b - a).cross(randomPoint(random, 1.0)).normalized();
    const Vector3d point = inside + anyPowerOfTen(random, -9.0, 1.0) * across;
    const double least = (point - closestPointOnTriangle(point, a, b, c)).norm();
    const double rounding = 1e-15 * (point.norm() + size);
    // It was up to 7e-8 of the size where areas are mostly rounding.
    ASSERT_LE(least, (point - inside).norm() + rounding) << "case " << i;
  }
}

}  // namespace
}  // namespace collision_monitor::test
