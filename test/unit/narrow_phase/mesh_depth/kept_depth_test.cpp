// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "narrow_phase/mesh_depth/mesh_depth.h"
#include "support/allocation_guard.h"
#include "support/expect_distance.h"
#include "support/query_meshes.h"
#include "support/sample_meshes.h"

// The depth of meshes that move, from query to query.
namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

constexpr std::uint32_t kBudget = 1000;

/// A cube from -1 to 1, and a bar of 0.2 x 0.4 x 0.6 that sticks in its face x = 1.
class KeptDepthTest : public testing::Test {
 protected:
  MeshDepth depth(const Pose& world_from_bar, std::uint32_t budget = kBudget) {
    return depthOf({cube_, world_from_cube_}, {bar_, world_from_bar}, *memory_, *kept_, budget);
  }
  MeshDepth standAt(const Pose& world_from_bar, int queries = 100) {
    for (int i = 1; i < queries; ++i) {
      depth(world_from_bar);
    }
    return depth(world_from_bar);
  }

  std::unique_ptr<MeshQueryMemory> memory_ = std::make_unique<MeshQueryMemory>();
  std::unique_ptr<KeptDepth> kept_ = std::make_unique<KeptDepth>();
  const MeshTree cube_{boxMesh({1, 1, 1}), true};
  const MeshTree bar_{boxMesh({0.1, 0.2, 0.3}), true};
  Pose world_from_cube_;
};

TEST_F(KeptDepthTest, barSlidesIn_depthFollowsExactly) {
  for (int step = 0; step < 100; ++step) {
    const double x = 1.09 - 0.001 * step;
    const MeshDepth found = depth(at(x, 0, 0));
    ASSERT_NEAR(found.deepest.distance, -(1.1 - x), kExact);
    expectNear(found.deepest.normal_a_to_b, {1, 0, 0}, "normal");
    EXPECT_NEAR(found.deepest.point_on_a.x(), 1.0, kExact);
    EXPECT_NEAR(found.deepest.point_on_b.x(), x - 0.1, kExact);
    expectConsistent(found.deepest);
  }
}

TEST_F(KeptDepthTest, otherOrder_turnsTheNormal) {
  for (const double x : {1.05, 1.049, 1.048}) {
    const MeshDepth found =
        depthOf({bar_, at(x, 0, 0)}, {cube_, Pose{}}, *memory_, *kept_, kBudget);
    EXPECT_NEAR(found.deepest.distance, x - 1.1, kExact);
    expectNear(found.deepest.normal_a_to_b, {-1, 0, 0}, "normal");
    expectConsistent(found.deepest);
  }
}

TEST_F(KeptDepthTest, slidesOut_isDeepNoMore) {
  depth(at(1.05, 0, 0));
  const MeshDepth touching = depth(at(1.101, 0, 0));
  EXPECT_EQ(touching.deepest.distance, 0.0);
  EXPECT_EQ(depth(at(1.5, 0, 0)).deepest.distance, 0.0);
  EXPECT_NEAR(depth(at(1.08, 0, 0)).deepest.distance, -0.02, kExact) << "and back in";
}

TEST_F(KeptDepthTest, stands_nothingIsMeasuredAnew) {
  const MeshDepth before = standAt(at(1.05, 0, 0));
  const MeshDepth after = depth(at(1.05, 0, 0));
  EXPECT_TRUE(after.is_complete);
  EXPECT_EQ(after.points, 0U);
  EXPECT_EQ(after.deepest.distance, before.deepest.distance);
  EXPECT_EQ(after.deepest.point_on_a, before.deepest.point_on_a);
  EXPECT_EQ(after.deepest.point_on_b, before.deepest.point_on_b);
}

TEST_F(KeptDepthTest, bothGoTheSameWay_theAnswerGoesWithThem) {
  standAt(at(1.05, 0, 0));
  world_from_cube_ = Pose{eighthTurn(), {3, 4, 5}};
  const MeshDepth found = depth(world_from_cube_ * at(1.05, 0, 0));
  EXPECT_TRUE(found.is_complete);
  EXPECT_NEAR(found.deepest.distance, -0.05, kExact);
  expectNear(found.deepest.normal_a_to_b, eighthTurn().col(0), "normal");
  EXPECT_LE(found.points, 1U) << "the corner alone, where rounding moved it";
}

TEST_F(KeptDepthTest, jump_isSearchedAnew) {
  standAt(at(1.05, 0, 0));
  // Through the face y = 1, where other corners are in.
  const MeshDepth found = depth(at(0, 1.17, 0));
  EXPECT_TRUE(found.is_complete);
  EXPECT_NEAR(found.deepest.distance, -0.03, kExact);
  expectNear(found.deepest.normal_a_to_b, {0, 1, 0}, "normal");
}

TEST_F(KeptDepthTest, turnsSlowly_anotherCornerIsFoundBeforeItIsDeeper) {
  // Two pegs stick in the face x = 1; one goes deeper while the other comes out, and back.
  const TriangleMesh peg = boxMesh({0.1, 0.02, 0.02});
  const MeshTree pegs(
      joined(moved(peg, Vector3d::Zero(), {0, 0, 0.3}), moved(peg, Vector3d::Zero(), {0, 0, -0.3})),
      true);
  Pose pose = at(1.05, 0, 0);
  int complete = 0;
  for (int step = 0; step <= 200; ++step) {
    const double turn = 0.05 * std::sin(0.05 * step);
    pose.rotation = Eigen::AngleAxisd(turn, Vector3d::UnitY()).toRotationMatrix();
    const MeshDepth found = depthOf({cube_, Pose{}}, {pegs, pose}, *memory_, *kept_, kBudget);
    // The corner (-0.1, 0.02, +-0.32), turned.
    const double x = 1.05 - 0.1 * std::cos(turn) - 0.32 * std::abs(std::sin(turn));
    ASSERT_GE(found.deepest.distance, x - 1.0 - kExact);
    if (found.is_complete) {
      ++complete;
      ASSERT_NEAR(found.deepest.distance, x - 1.0, kExact) << "step " << step;
    }
  }
  EXPECT_GT(complete, 100);
}

TEST_F(KeptDepthTest, tipThatWasOut_isFoundWhenItComesBackIn) {
  const MeshTree spike({{{0, 0, -0.4}, {0.3, 0, 0}, {-0.2, 0.2, 0}, {-0.2, -0.2, 0}},
                        {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}}},
                       true);
  for (int step = 0; step <= 80; ++step) {
    const double depth_of_tip = 0.002 * std::cos(0.1 * step);
    const MeshDepth found =
        depthOf({cube_, Pose{}}, {spike, at(0, 0, 1.4 - depth_of_tip)}, *memory_, *kept_, kBudget);
    ASSERT_TRUE(found.is_complete) << "step " << step;
    ASSERT_NEAR(found.deepest.distance, std::min(0.0, -depth_of_tip), kExact) << "step " << step;
  }
}

TEST_F(KeptDepthTest, smallSteps_areCompleteWithoutSearchingAllAgain) {
  const MeshTree body(bumpyMesh(1.0, 30), true);
  Pose pose{eighthTurn(), {0.5, 0.1, 0.05}};
  const auto next = [&] {
    return depthOf({body, Pose{}}, {body, pose}, *memory_, *kept_, kBudget);
  };
  const std::uint32_t all_points = next().points;
  std::uint32_t points = 0;
  int complete = 0;
  constexpr int kSteps = 400;
  for (int step = 0; step < kSteps; ++step) {
    pose.translation.x() += 2e-5;
    const MeshDepth found = next();
    points += found.points;
    complete += found.is_complete ? 1 : 0;
  }
  EXPECT_GT(complete, kSteps / 2);
  EXPECT_LT(points, kSteps * all_points / 10);
}

TEST_F(KeptDepthTest, longWay_roundsNothing) {
  for (int step = 0; step < 60'000; ++step) {
    const double x = step % 2 == 0 ? 1.03 : 1.01;
    const MeshDepth found = depth(at(x, 0, 0));
    ASSERT_NEAR(found.deepest.distance, x - 1.1, kExact);
    ASSERT_LT(kept_->moved, 1001.0) << "limits lose digits to it";
  }
}

TEST_F(KeptDepthTest, moreCornersAsDeepThanAreKept_isCompleteOnceItStands) {
  // The rim of a tube that goes straight into the cube: each of its corners is the deepest.
  const MeshTree tube(prismMesh(0.5, 0.5, 200), true);
  bool is_whole = true;
  const auto depth_at = [&](double z) {
    MeshDepth found = depthOf({cube_, Pose{}}, {tube, at(0, 0, z)}, *memory_, *kept_, kBudget);
    is_whole = is_whole && kept_->sides[1].is_whole;
    return found;
  };
  for (int step = 0; step < 500; ++step) {
    const double z = 1.45 - 1e-4 * step;
    ASSERT_NEAR(depth_at(z).deepest.distance, z - 1.5, kExact);
  }
  EXPECT_FALSE(is_whole) << "all corners were kept";
  MeshDepth stands;
  for (int query = 0; query < 1000 && !stands.is_complete; ++query) {
    stands = depth_at(1.4);
  }
  EXPECT_TRUE(stands.is_complete);
  EXPECT_NEAR(stands.deepest.distance, -0.1, kExact);
}

TEST_F(KeptDepthTest, smallBudget_isCompleteInTime) {
  const MeshTree body(bumpyMesh(1.0, 30), true);
  const Pose turned{eighthTurn(), {0.5, 0.1, 0.05}};
  const auto nothing = std::make_unique<KeptDepth>();
  const MeshDepth all = depthOf({body, Pose{}}, {body, turned}, *memory_, *nothing, 200000);
  MeshDepth found;
  double last = 0.0;
  for (int query = 0; query < 1000 && !found.is_complete; ++query) {
    found = depthOf({body, Pose{}}, {body, turned}, *memory_, *kept_, 4);
    ASSERT_LE(found.points, 4U + 3U) << "a triangle has three corners";
    ASSERT_LE(found.deepest.distance, last);
    last = found.deepest.distance;
  }
  EXPECT_TRUE(found.is_complete);
  EXPECT_NEAR(found.deepest.distance, all.deepest.distance, kExact);
}

TEST_F(KeptDepthTest, poseNotFiniteBetween_saysNothingAndLeavesNoTrace) {
  standAt(at(1.05, 0, 0));
  const MeshDepth bad = depth(at(std::numeric_limits<double>::quiet_NaN(), 0, 0));
  EXPECT_FALSE(bad.is_complete);
  EXPECT_EQ(bad.deepest.distance, 0.0);
  EXPECT_EQ(bad.points, 0U);
  EXPECT_NEAR(depth(at(1.05, 0, 0)).deepest.distance, -0.05, kExact);
}

TEST_F(KeptDepthTest, forgotten_isAsNew) {
  standAt(at(1.05, 0, 0));
  forget(*kept_);
  const MeshDepth again = depth(at(1.04, 0, 0));
  const auto fresh = std::make_unique<KeptDepth>();
  const MeshDepth found =
      depthOf({cube_, Pose{}}, {bar_, at(1.04, 0, 0)}, *memory_, *fresh, kBudget);
  EXPECT_EQ(again.points, found.points);
  EXPECT_EQ(again.deepest.distance, found.deepest.distance);
  EXPECT_EQ(again.deepest.point_on_b, found.deepest.point_on_b);
}

TEST_F(KeptDepthTest, openMeshes_haveNoInside) {
  const MeshTree open(boxMesh({1, 1, 1}), false);
  const MeshDepth found = depthOf({open, Pose{}}, {open, at(1.9, 0, 0)}, *memory_, *kept_, kBudget);
  EXPECT_TRUE(found.is_complete);
  EXPECT_EQ(found.deepest.distance, 0.0);
}

TEST_F(KeptDepthTest, allocatesNothing) {
  const AllocationGuard guard;
  depth(at(1.05, 0, 0));
  depth(at(1.04, 0, 0));
  EXPECT_EQ(guard.count(), 0U);
}

}  // namespace
}  // namespace collision_monitor::test
