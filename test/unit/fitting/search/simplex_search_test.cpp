// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/search/simplex_search.h"

#include <gtest/gtest.h>

#include <cmath>

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

/// A valley with kinks, least at (0.2, -0.1, 0.05).
double valley(const Vector3d& at) {
  return std::abs(at.x() - 0.2) + 3.0 * std::abs(at.y() + 0.1) + std::pow(at.z() - 0.05, 2);
}

TEST(SimplexSearch, valley_isSearchedToItsBottom) {
  const Vector3d found = searchSimplex<3>({0.1, 1e-9, 2000}, valley);
  EXPECT_NEAR((found - Vector3d(0.2, -0.1, 0.05)).norm(), 0.0, 1e-3);
}

TEST(SimplexSearch, costThatStopsAtTheBound_leadsToTheSamePlace) {
  int stopped = 0;
  const auto bounded = [&](const Vector3d& at, double bound) {
    stopped += valley(at) >= bound ? 1 : 0;
    return valley(at) >= bound ? bound : valley(at);
  };
  for (const int evaluations : {10, 50, 300}) {
    const SimplexLimits limits{0.1, 1e-6, evaluations};
    EXPECT_EQ(searchSimplex<3>(limits, bounded), searchSimplex<3>(limits, valley)) << evaluations;
  }
  EXPECT_GT(stopped, 20);
}

}  // namespace
}  // namespace collision_monitor
