// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/proofs/near_cores.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <random>

#include "support/fixed_seed.h"

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

class Draw {
 public:
  double next(double low, double high) {
    return std::uniform_real_distribution<>(low, high)(random_);
  }
  Vector3d direction() { return Vector3d(next(-1, 1), next(-1, 1), next(-1, 1)).normalized(); }
  TurnedCore core() {
    TurnedCore core;
    core.rotation = Eigen::AngleAxisd(next(0, 3), direction()).toRotationMatrix();
    core.center = next(0.0, 1.0) * direction();
    core.half_extents = {next(0, 0.4), next(0, 0.1), next(-0.1, 0.4)};
    core.half_extents = core.half_extents.cwiseMax(0.0);
    core.radius = next(-0.1, 0.2);
    core.radius = std::max(core.radius, 0.0);
    return core;
  }
  std::vector<TurnedCore> cores(std::size_t count) {
    std::vector<TurnedCore> cores;
    for (std::size_t i = 0; i < count; ++i) {
      cores.push_back(core());
    }
    return cores;
  }
  Vector3d onSurface(const TurnedCore& core) {
    Vector3d corner = direction().cwiseSign().cwiseProduct(core.half_extents);
    corner[next(0, 1) < 0.5 ? 0 : 2] *= next(-1, 1);
    return core.center + core.rotation * corner + core.radius * direction();
  }

 private:
  std::mt19937 random_{kSeed};
};

bool isStrictlyInside(const TurnedCore& core, const Vector3d& point) {
  const Vector3d out =
      (core.rotation.transpose() * (point - core.center)).cwiseAbs() - core.half_extents;
  return out.maxCoeff() < 0.0 || out.cwiseMax(0.0).norm() < core.radius;
}

TEST(NearCores, marksWhatOneOfAllCoresHolds) {
  constexpr double kSlack = 0.01;
  Draw draw;
  int held = 0;
  for (const std::size_t count : {0U, 1U, 3U, 12U, 40U}) {
    for (int round = 0; round < 200; ++round) {
      const std::vector<TurnedCore> others = draw.cores(count);
      const TurnedCore core = draw.core();
      PointRows points;
      for (int i = 0; i < 19; ++i) {
        points.add(draw.onSurface(core) + draw.next(0.0, kSlack) * draw.direction());
      }
      std::array<unsigned char, PointRows::kMost> is_held;
      NearCores(others, core, kSlack).mark(points, is_held);
      for (std::size_t i = 0; i < points.count; ++i) {
        const Vector3d point(points.at[0][i], points.at[1][i], points.at[2][i]);
        const bool is_inside =
            std::any_of(others.begin(), others.end(),
                        [&](const TurnedCore& other) { return isStrictlyInside(other, point); });
        EXPECT_EQ(is_held[i] != 0, is_inside) << point.transpose();
        held += is_inside ? 1 : 0;
      }
    }
  }
  EXPECT_GT(held, 1000);
}

}  // namespace
}  // namespace collision_monitor::test
