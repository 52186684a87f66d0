// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "collision_monitor/pipeline/run_cycle.h"
#include "support/hand_made_setup.h"

namespace collision_monitor {
namespace {

using test::handMadeSetup;
using test::knownPoses;

const Eigen::Matrix3d kEighthTurn =
    Eigen::AngleAxisd(0.25 * 3.14159265358979, Eigen::Vector3d::UnitZ()).toRotationMatrix();

/// One cycle with a combined run; the reach is 0.2 m. The second link stands at `translation`, and
/// both are turned by `rotation`.
CycleCounters runTwo(const Shape& shape, const Eigen::Vector3d& translation,
                     const Eigen::Matrix3d& rotation) {
  const CycleSetup setup = handMadeSetup({{0, shape}, {1, shape}});
  CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::combination);
  LinkPoses poses = knownPoses(setup);
  poses.world_from_link[0].rotation = rotation;
  poses.world_from_link[1] = {rotation, translation};
  runCycle(setup, poses, buffers);
  return buffers.counters;
}

TEST(CullCandidates, ballsAcrossACorner_spheresPart) {
  // 0.35 m along two axes: boxes of 0.2 m half edge meet, the balls are 0.295 m apart.
  const CycleCounters counters =
      runTwo(Sphere{0.1}, {0.35, 0.35, 0.0}, Eigen::Matrix3d::Identity());
  EXPECT_EQ(counters.candidates, 1U);
  EXPECT_EQ(counters.culled_by_spheres, 1U);
  EXPECT_EQ(counters.culled_by_boxes, 0U);
}

TEST(CullCandidates, longBoxesSideBySideAtAnAngle_orientedBoxesPart) {
  // Along their common short axis the boxes are 0.5 m - 2 * 0.05 m = 0.4 m apart.
  const CycleCounters counters =
      runTwo(Box{{1.0, 0.05, 0.05}}, kEighthTurn * Eigen::Vector3d(0.0, 0.5, 0.0), kEighthTurn);
  EXPECT_EQ(counters.candidates, 1U);
  EXPECT_EQ(counters.culled_by_spheres, 0U);
  EXPECT_EQ(counters.culled_by_boxes, 1U);
}

TEST(CullCandidates, withinReach_stays) {
  for (const Shape& shape : {Shape(Box{{1.0, 0.05, 0.05}}),
                             Shape(RoundedBox{{0.5, 0.0, 0.02}, 0.05}), Shape(Sphere{0.05})}) {
    const CycleCounters counters =
        runTwo(shape, kEighthTurn * Eigen::Vector3d(0.0, 0.299, 0.0), kEighthTurn);
    EXPECT_EQ(counters.candidates, 1U);
    EXPECT_EQ(counters.culled_by_spheres + counters.culled_by_boxes, 0U);
    EXPECT_EQ(counters.measured, 1U);
  }
}

TEST(CullCandidates, metOnTheWay_stays) {
  // A ball flies past another in one cycle, from 1 m on one side to 1 m on the other.
  CycleSetup setup = handMadeSetup({{0, Sphere{0.1}}, {1, Sphere{0.1}}});
  setup.is_continuous = true;
  CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::combination);
  LinkPoses poses = knownPoses(setup);
  poses.stamp_ns = 1000000000;
  poses.world_from_link[1].translation.x() = -1.0;
  runCycle(setup, poses, buffers);
  poses.stamp_ns += 10000000;
  poses.world_from_link[1].translation.x() = 1.0;
  runCycle(setup, poses, buffers);
  EXPECT_EQ(buffers.distances.passed.size(), 1U);
}

}  // namespace
}  // namespace collision_monitor
