// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "narrow_phase/mesh_depth/mesh_depth.h"
#include "support/fixed_seed.h"
#include "support/query_meshes.h"
#include "support/random_poses.h"
#include "support/sample_meshes.h"

// Meshes that walk at random within each other: the depth kept from query to query, and that of a
// complete search.
namespace collision_monitor::test::kept_depth_laws {
namespace {

constexpr double kRounding = 1e-12;  // [m]

class KeptDepthLaws : public testing::Test {
 protected:
  KeptDepthLaws() {
    trees_.emplace_back(bumpyMesh(1.0, 24), true);
    trees_.emplace_back(bumpyMesh(0.5, 16), true);
    trees_.emplace_back(boxMesh({0.3, 0.1, 0.2}), true);
    trees_.emplace_back(sphereMesh(0.4, 20), true);
  }

  const MeshTree& anyTree() { return trees_[random_() % trees_.size()]; }

  Pose nextPose(const Pose& pose, double shift) {
    switch (random_() % 60) {
      case 0:
        return randomPose(random_, 0.3);
      case 1:
        return pose;
      default:
        const Eigen::AngleAxisd whole(randomRotation(random_));
        return {Eigen::AngleAxisd(shift * whole.angle(), whole.axis()) * pose.rotation,
                pose.translation + randomPoint(random_, shift)};
    }
  }

  double completeDepth(const PlacedMesh& a, const PlacedMesh& b) {
    const auto nothing = std::make_unique<KeptDepth>();
    const MeshDepth found = depthOf(a, b, *memory_, *nothing, 2000000);
    EXPECT_TRUE(found.is_complete);
    return -found.deepest.distance;
  }

  Random random_{kSeed};
  std::vector<MeshTree> trees_;
  std::unique_ptr<MeshQueryMemory> memory_ = std::make_unique<MeshQueryMemory>();
};

// [m] By how much the point is outside of the mesh; negative inside.
double outside(const PlacedMesh& mesh, const Eigen::Vector3d& point, MeshQueryMemory& memory) {
  const Pose pose{Eigen::Matrix3d::Identity(), point};
  const Shape shape = Sphere{0.0};
  return distanceBetween(mesh, {shape, pose}, memory).measured.distance;
}

/// Both points are as deep in each other as told; one of them is the corner of its mesh, that deep
/// in the other mesh.
void expectPoints(const PlacedMesh& a, const PlacedMesh& b, const SignedDistance& deepest,
                  MeshQueryMemory& memory) {
  const Eigen::Vector3d between = deepest.point_on_b - deepest.point_on_a;
  ASSERT_LE((between - deepest.distance * deepest.normal_a_to_b).norm(), kRounding);
  const double b_in_a = outside(a, deepest.point_on_b, memory);
  const double a_in_b = outside(b, deepest.point_on_a, memory);
  ASSERT_NEAR(std::min(b_in_a, a_in_b), deepest.distance, kRounding);
}

/// Once meshes stand the depth becomes that of a complete search.
void expectCompleteAtRest(const PlacedMesh& a, const PlacedMesh& b, double complete,
                          KeptDepth& kept, MeshQueryMemory& memory) {
  MeshDepth stands;
  for (int query = 0; query < 1000 && !stands.is_complete; ++query) {
    stands = depthOf(a, b, memory, kept, 60);
  }
  ASSERT_TRUE(stands.is_complete);
  ASSERT_NEAR(-stands.deepest.distance, complete, kRounding);
}

TEST_F(KeptDepthLaws, walks_neverDeeperThanAllCornersAndAsDeepOnceTheyStand) {
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  double kept_sum = 0.0;
  double complete_sum = 0.0;
  int deep = 0;
  int complete_walking = 0;
  for (int walk = 0; walk < 40; ++walk) {
    const auto kept = std::make_unique<KeptDepth>();
    const auto twin = std::make_unique<KeptDepth>();
    const double shift = std::pow(10.0, uniform(random_, -5.0, -2.0));
    Pose world_from_a = randomPose(random_, 0.2);
    Pose world_from_b = randomPose(random_, 0.2);
    const PlacedMesh a{anyTree(), world_from_a};
    const PlacedMesh b{anyTree(), world_from_b};
    for (int step = 0; step < 100; ++step) {
      SCOPED_TRACE(testing::Message() << "walk " << walk << ", step " << step);
      world_from_a = nextPose(world_from_a, shift);
      world_from_b = nextPose(world_from_b, shift);
      const MeshDepth found = depthOf(a, b, *memory_, *kept, 60);
      const double complete = completeDepth(a, b);
      const double depth = -found.deepest.distance;
      ASSERT_LE(depth, complete + kRounding);
      ASSERT_TRUE(!found.is_complete || depth >= complete - kRounding);
      if (depth > 0.0) {
        ASSERT_NO_FATAL_FAILURE(expectPoints(a, b, found.deepest, *memory_));
      }
      const MeshDepth same = depthOf(a, b, *memory_, *twin, 60);
      ASSERT_EQ(same.deepest.distance, found.deepest.distance);
      ASSERT_EQ(same.deepest.point_on_a, found.deepest.point_on_a);
      ASSERT_EQ(same.points, found.points);
      kept_sum += depth;
      complete_sum += complete;
      deep += depth > 0.0 ? 1 : 0;
      complete_walking += found.is_complete && depth > 0.0 ? 1 : 0;
    }
    ASSERT_NO_FATAL_FAILURE(expectCompleteAtRest(a, b, completeDepth(a, b), *kept, *memory_));
  }
  EXPECT_GT(deep, 2000);
  EXPECT_GT(complete_walking, 500) << "the way gone proves little";
  EXPECT_GT(kept_sum, 0.99 * complete_sum) << "what is kept is worth little";
}

// What a search looked at before the step may be the deepest after it.
TEST_F(KeptDepthLaws, stepWithinASearch_standsForNothingUntilAllIsLookedAtAgain) {
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  int steps_within = 0;
  for (int round = 0; round < 200; ++round) {
    SCOPED_TRACE(testing::Message() << "round " << round);
    const auto kept = std::make_unique<KeptDepth>();
    const Pose world_from_a;
    Pose world_from_b = randomPose(random_, 0.2);
    const PlacedMesh a{anyTree(), world_from_a};
    const PlacedMesh b{anyTree(), world_from_b};
    const MeshDepth before = depthOf(a, b, *memory_, *kept, 30);
    const Eigen::AngleAxisd turn(0.1, randomPoint(random_, 1.0).normalized());
    world_from_b.rotation = world_from_b.rotation * turn;
    MeshDepth found = depthOf(a, b, *memory_, *kept, 30);
    steps_within += !before.is_complete && found.deepest.distance < 0.0 ? 1 : 0;
    for (int query = 0; query < 1000 && !found.is_complete; ++query) {
      found = depthOf(a, b, *memory_, *kept, 30);
    }
    ASSERT_TRUE(found.is_complete);
    ASSERT_NEAR(-found.deepest.distance, completeDepth(a, b), kRounding);
  }
  EXPECT_GT(steps_within, 50);
}

}  // namespace
}  // namespace collision_monitor::test::kept_depth_laws
