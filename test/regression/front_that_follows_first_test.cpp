// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

#include "narrow_phase/mesh/mesh_distance.h"
#include "support/own_front.h"
#include "support/sample_meshes.h"

// The nearest triangles of the last query went into the front with a bound at the new pose before
// the front had followed there. The motion then counted twice, and what was near was passed over.
namespace collision_monitor::test {
namespace {

TEST(FrontThatFollowsFirst, nearestThatGoesBeyondTheLimitAndComesBack) {
  const auto memory = std::make_unique<MeshQueryMemory>();
  const TriangleMesh one{{{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}}, {{0, 1, 2}}};
  const MeshTree tree(one);
  OwnFront front;
  const std::vector<std::pair<double, double>> heights_and_limits{
      {0.02, 1.0}, {0.30, 0.1}, {0.01, 0.1}, {-0.01, 0.1}, {0.005, 0.1}};
  for (const auto& [height, limit] : heights_and_limits) {
    const Pose pose{Eigen::Matrix3d::Identity(), {0.0, 0.0, height}};
    MeshQueryLimits limits;
    limits.stop_beyond = limit;
    const MeshDistance truth =
        distanceBetween({tree, Pose()}, {tree, pose}, *memory, TrianglePair{}, limits);
    const MeshDistance found =
        distanceBetween({tree, Pose()}, {tree, pose}, *memory, front, limits);
    EXPECT_EQ(found.state, truth.state) << height;
    EXPECT_NEAR(found.measured.distance, truth.measured.distance, 1e-12) << height;
  }
}

}  // namespace
}  // namespace collision_monitor::test
