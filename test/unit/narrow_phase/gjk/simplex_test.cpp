// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/gjk/simplex.h"

#include <gtest/gtest.h>

#include <vector>

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

Simplex simplexOf(const std::vector<Vector3d>& points) {
  Simplex simplex;
  for (std::size_t i = 0; i < points.size(); ++i) {
    simplex.vertices[i].difference = points[i];
  }
  return simplex;
}

TEST(Simplex, edgePastTheOrigin_isTakenWhole) {
  Simplex simplex = simplexOf({{-1, 2, 0}, {3, 2, 0}});
  ASSERT_TRUE(spanAll(2, simplex));
  EXPECT_EQ(simplex.size, 2);
  EXPECT_NEAR(simplex.distance, 2.0, 1e-15);
  EXPECT_NEAR(simplex.weights[0], 0.75, 1e-15);
  EXPECT_NEAR((simplex.normal - Vector3d::UnitY()).norm(), 0.0, 1e-15);
}

TEST(Simplex, triangleOverTheOrigin_isTakenWhole) {
  Simplex simplex = simplexOf({{-1, -1, 5}, {2, -1, 5}, {-1, 2, 5}});
  ASSERT_TRUE(spanAll(3, simplex));
  EXPECT_EQ(simplex.size, 3);
  EXPECT_NEAR(simplex.distance, 5.0, 1e-14);
  EXPECT_NEAR((simplex.nearest - Vector3d(0, 0, 5)).norm(), 0.0, 1e-14);
}

TEST(Simplex, cornersThatAreNotNeeded_areRefusedWhole) {
  Simplex edge = simplexOf({{1, 2, 0}, {3, 2, 0}});
  EXPECT_FALSE(spanAll(2, edge));
  EXPECT_EQ(edge.size, 0);
  Simplex triangle = simplexOf({{-1, 1, 5}, {2, 1, 5}, {-1, 4, 5}});
  EXPECT_FALSE(spanAll(3, triangle));
  EXPECT_EQ(triangle.size, 0);
}

TEST(Simplex, sliver_isRefused) {
  Simplex simplex = simplexOf({{-1, 0, 5}, {1, -1e-5, 5}, {0, 1e-5, 5}});
  EXPECT_FALSE(spanAll(3, simplex));
}

TEST(Simplex, onePoint_isTaken) {
  Simplex simplex = simplexOf({{0, 3, 4}});
  ASSERT_TRUE(spanAll(1, simplex));
  EXPECT_EQ(simplex.distance, 5.0);
  EXPECT_NEAR((simplex.normal - Vector3d(0, 0.6, 0.8)).norm(), 0.0, 1e-15);
}

TEST(Simplex, noPointOrFour_areLeftToInsertion) {
  Simplex simplex = simplexOf({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}});
  EXPECT_FALSE(spanAll(0, simplex));
  EXPECT_FALSE(spanAll(4, simplex));
}

}  // namespace
}  // namespace collision_monitor
