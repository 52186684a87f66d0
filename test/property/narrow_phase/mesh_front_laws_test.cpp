// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "narrow_phase/mesh/mesh_distance.h"
#include "narrow_phase/triangle/triangle_triangle.h"
#include "support/allocation_guard.h"
#include "support/fixed_seed.h"
#include "support/own_front.h"
#include "support/query_meshes.h"
#include "support/random_poses.h"
#include "support/sample_meshes.h"

// Meshes that walk at random: what a query finds from the front of the last one, and from the
// roots.
namespace collision_monitor::test::mesh_front_laws {
namespace {

constexpr double kRounding = 1e-13;  // [m], for coordinates of a metre or two

/// By up to `shift` [m] along each axis and by as many rad, or ten times as many.
Pose stepFrom(const Pose& pose, double shift, Random& random) {
  const double turn = shift * (random() % 4 == 0 ? 10.0 : 1.0);
  const Eigen::AngleAxisd whole(randomRotation(random));
  return {Eigen::AngleAxisd(turn * whole.angle(), whole.axis()) * pose.rotation,
          pose.translation + randomPoint(random, shift)};
}

/// Often slow, sometimes at rest, away in a jump or inside.
Pose nextPose(const Pose& pose, double shift, Random& random) {
  switch (random() % 40) {
    case 0:
      return randomPose(random, 1.5);
    case 1:
      return randomPose(random, 0.1);
    case 2:
    case 3:
      return pose;
    default:
      return stepFrom(pose, shift, random);
  }
}

class MeshFrontLaws : public testing::Test {
 protected:
  MeshFrontLaws() {
    trees_.emplace_back(bumpyMesh(1.0, 24), true);
    trees_.emplace_back(bumpyMesh(0.3, 16), true);
    trees_.emplace_back(boxMesh({0.3, 0.1, 0.2}), true);
    trees_.emplace_back(sphereMesh(0.4, 20), false);
    trees_.emplace_back(triangleSoup(0.5, 60, random_), false);
  }

  const MeshTree& anyTree() { return trees_[random_() % trees_.size()]; }

  MeshQueryLimits anyLimits() {
    MeshQueryLimits limits;
    if (random_() % 5 == 0) {
      limits.stop_beyond = uniform(random_, 0.0, 0.5);
    }
    if (random_() % 10 == 0) {
      limits.visit_budget = static_cast<std::uint32_t>(random_() % 60);
    }
    return limits;
  }

  Random random_{kSeed};
  std::vector<MeshTree> trees_;
  std::unique_ptr<MeshQueryMemory> memory_ = std::make_unique<MeshQueryMemory>();
};

/// Where a budget ended the search it may tell a lower bound instead.
void expectTruth(const MeshDistance& found, const MeshDistance& truth, bool is_cut_short) {
  if (is_cut_short && found.state == MeshState::lower_bound) {
    ASSERT_LE(found.measured.distance, truth.measured.distance + kRounding);
  } else {
    ASSERT_EQ(found.state, truth.state);
    ASSERT_NEAR(found.measured.distance, truth.measured.distance, kRounding);
  }
}

TEST_F(MeshFrontLaws, answers_areThoseFromTheRoots) {
  int inside = 0;
  int bounded = 0;
  double visits = 0.0;
  double visits_from_roots = 0.0;
  for (int walk = 0; walk < 60; ++walk) {
    const MeshTree& a = anyTree();
    const MeshTree& b = anyTree();
    const auto front = std::make_unique<OwnFront>();
    const double shift = std::pow(10.0, uniform(random_, -7.0, -2.0));
    Pose world_from_a = randomPose(random_, 0.5);
    Pose world_from_b = randomPose(random_, 1.0);
    for (int step = 0; step < 150; ++step) {
      SCOPED_TRACE(testing::Message() << "walk " << walk << ", step " << step);
      world_from_a = nextPose(world_from_a, 0.1 * shift, random_);
      world_from_b = nextPose(world_from_b, shift, random_);
      const MeshQueryLimits limits = anyLimits();
      const MeshQueryLimits unhurried{limits.stop_beyond};
      const MeshDistance truth =
          distanceBetween({a, world_from_a}, {b, world_from_b}, *memory_, {}, unhurried);
      const std::uint64_t to_loosen = front->size / 128;
      const MeshDistance found =
          distanceBetween({a, world_from_a}, {b, world_from_b}, *memory_, *front, limits);
      ASSERT_LE(found.visits, limits.visit_budget + to_loosen + 4)
          << "the last nearest and one more to the end";
      const bool is_cut_short = limits.visit_budget != unhurried.visit_budget;
      ASSERT_NO_FATAL_FAILURE(expectTruth(found, truth, is_cut_short));
      visits += is_cut_short ? 0.0 : found.visits;
      visits_from_roots += is_cut_short ? 0.0 : truth.visits;
      bounded += is_cut_short && found.state == MeshState::lower_bound ? 1 : 0;
      inside += truth.state == MeshState::overlapping ? 1 : 0;
    }
  }
  EXPECT_GT(inside, 200);
  EXPECT_GT(bounded, 200);
  EXPECT_LT(visits, 0.7 * visits_from_roots) << "most steps are small";
}

TEST_F(MeshFrontLaws, posesNotFiniteBetween_areUnknownAndLeaveNoTrace) {
  const auto front = std::make_unique<OwnFront>();
  Pose pose = randomPose(random_, 1.0);
  for (int step = 0; step < 300; ++step) {
    pose = nextPose(pose, 1e-3, random_);
    if (random_() % 3 == 0) {
      Pose bad = pose;
      bad.rotation(1, 2) = random_() % 2 == 0 ? std::numeric_limits<double>::quiet_NaN()
                                              : std::numeric_limits<double>::infinity();
      ASSERT_EQ(distanceBetween({trees_[0], Pose{}}, {trees_[1], bad}, *memory_, *front).state,
                MeshState::unknown);
    }
    const MeshDistance truth = distanceBetween({trees_[0], Pose{}}, {trees_[1], pose}, *memory_);
    const MeshDistance found =
        distanceBetween({trees_[0], Pose{}}, {trees_[1], pose}, *memory_, *front);
    ASSERT_EQ(found.state, truth.state) << step;
    ASSERT_NEAR(found.measured.distance, truth.measured.distance, kRounding) << step;
  }
}

/// Where neighbours' distances differ least: faces side by side, whose pairs fill any front; and
/// all that it keeps may have come near at once, by a jump.
TEST_F(MeshFrontLaws, moreThanTheFrontHolds_isFoundFromTheRoots) {
  const MeshTree fine(sphereMesh(0.5, 80), true);
  const MeshTree around(sphereMesh(0.51, 80), false);
  for (const std::size_t blocks : {0, 1, 3, 8}) {
    const auto front = std::make_unique<OwnFront>(blocks);
    Pose pose{};
    for (int step = 0; step < 30; ++step) {
      pose = step > 20 && step % 2 == 1 ? randomPose(random_, 1.2)
                                        : stepFrom(step > 20 ? Pose{} : pose, 1e-4, random_);
      const MeshDistance truth = distanceBetween({fine, Pose{}}, {around, pose}, *memory_);
      const MeshDistance found = distanceBetween({fine, Pose{}}, {around, pose}, *memory_, *front);
      ASSERT_EQ(found.state, truth.state) << blocks << ' ' << step;
      ASSERT_NEAR(found.measured.distance, truth.measured.distance, kRounding) << step;
    }
  }
}

/// Fronts that take blocks from each other, in turns and with long rests.
TEST_F(MeshFrontLaws, frontsOfOnePool_areAsFromTheRoots) {
  FrontPool pool(3);
  std::vector<std::unique_ptr<MeshFront>> fronts;
  std::vector<Pose> poses(trees_.size());
  for (std::size_t i = 0; i < trees_.size(); ++i) {
    fronts.push_back(std::make_unique<MeshFront>(pool));
  }
  for (int turn = 0; turn < 12; ++turn) {
    const std::size_t asked = random_() % trees_.size();
    for (int step = 0; step < 1500; ++step) {
      const std::size_t i = step % 100 == 0 ? random_() % trees_.size() : asked;
      poses[i] = nextPose(poses[i], 1e-3, random_);
      const PlacedMesh b{trees_[i], poses[i]};
      const MeshDistance found = distanceBetween({trees_[0], Pose{}}, b, *memory_, *fronts[i]);
      if (step % 50 == 0) {
        const MeshDistance truth = distanceBetween({trees_[0], Pose{}}, b, *memory_);
        ASSERT_EQ(found.state, truth.state) << turn << ' ' << step;
        ASSERT_NEAR(found.measured.distance, truth.measured.distance, kRounding) << turn;
      }
    }
  }
}

TEST_F(MeshFrontLaws, withATolerance_shortByNoMore) {
  MeshQueryLimits limits;
  limits.tolerance = 1e-3;
  const auto front = std::make_unique<OwnFront>();
  Pose pose = randomPose(random_, 1.0);
  for (int step = 0; step < 500; ++step) {
    pose = nextPose(pose, 1e-3, random_);
    const MeshDistance truth = distanceBetween({trees_[0], Pose{}}, {trees_[1], pose}, *memory_);
    const MeshDistance found =
        distanceBetween({trees_[0], Pose{}}, {trees_[1], pose}, *memory_, *front, limits);
    ASSERT_EQ(found.state, truth.state) << step;
    ASSERT_LE(found.measured.distance, truth.measured.distance + kRounding) << step;
    ASSERT_GE(found.measured.distance, truth.measured.distance - limits.tolerance) << step;
  }
}

/// Solids of each kind beside a mesh.
TEST_F(MeshFrontLaws, solids_areAsFromTheRoots) {
  constexpr double kSearched = 1e-9;  // [m] with cylinders
  const std::vector<ConvexGeometry> solids{Sphere{0.1}, Capsule{0.05, 0.2}, Box{{0.1, 0.2, 0.05}},
                                           RoundedBox{{0.1, 0.05, 0.1}, 0.03}, Cylinder{0.1, 0.1}};
  int overlapping = 0;
  double visits = 0.0;
  double visits_from_roots = 0.0;
  for (int walk = 0; walk < 60; ++walk) {
    const MeshTree& mesh = anyTree();
    const ConvexGeometry& solid = solids[random_() % solids.size()];
    const auto front = std::make_unique<OwnFront>();
    const double shift = std::pow(10.0, uniform(random_, -6.0, -2.0));
    Pose pose = randomPose(random_, 1.0);
    for (int step = 0; step < 100; ++step) {
      SCOPED_TRACE(testing::Message() << "walk " << walk << ", step " << step);
      pose = nextPose(pose, shift, random_);
      const MeshQueryLimits unhurried{anyLimits().stop_beyond};
      const MeshDistance truth =
          distanceBetween({mesh, Pose{}}, PlacedConvex{solid, pose}, *memory_, {}, unhurried);
      const MeshDistance found =
          distanceBetween({mesh, Pose{}}, PlacedConvex{solid, pose}, *memory_, *front, unhurried);
      ASSERT_EQ(found.state, truth.state);
      ASSERT_NEAR(found.measured.distance, truth.measured.distance, kSearched);
      visits += found.visits;
      visits_from_roots += truth.visits;
      overlapping += truth.state == MeshState::overlapping ? 1 : 0;
    }
  }
  EXPECT_GT(overlapping, 200);
  EXPECT_LT(visits, 0.7 * visits_from_roots) << "most steps are small";
}

/// What the budget leaves is a bound, and no front is the worse for it.
TEST_F(MeshFrontLaws, solidsWithABudget_boundedByTheTruth) {
  const ConvexGeometry solid = Box{{0.1, 0.2, 0.05}};
  const auto front = std::make_unique<OwnFront>();
  Pose pose = randomPose(random_, 1.0);
  for (int step = 0; step < 2000; ++step) {
    pose = nextPose(pose, 1e-3, random_);
    MeshQueryLimits limits;
    limits.visit_budget = random_() % 3 == 0 ? 1000000 : static_cast<std::uint32_t>(random_() % 9);
    const MeshDistance truth =
        distanceBetween({trees_[0], Pose{}}, PlacedConvex{solid, pose}, *memory_);
    const MeshDistance found =
        distanceBetween({trees_[0], Pose{}}, PlacedConvex{solid, pose}, *memory_, *front, limits);
    if (found.state == MeshState::lower_bound) {
      ASSERT_LE(found.measured.distance, truth.measured.distance + kRounding) << step;
    } else if (limits.visit_budget > 9 || found.state == MeshState::exact) {
      ASSERT_EQ(found.state, truth.state) << step;
      ASSERT_NEAR(found.measured.distance, truth.measured.distance, kRounding) << step;
    }
  }
}

/// Where a front knows no step yet, and the nearest triangles are told with a tolerance.
TEST_F(MeshFrontLaws, firstQueries_nameTheNearestTriangles) {
  MeshQueryLimits limits;
  limits.tolerance = 0.02;
  for (int query = 0; query < 2000; ++query) {
    const MeshTree& a = trees_[random_() % 3];
    const MeshTree& b = trees_[random_() % 3];
    const Pose pose = randomPose(random_, 2.0);
    const auto front = std::make_unique<OwnFront>();
    const MeshDistance truth = distanceBetween({a, Pose{}}, {b, pose}, *memory_);
    const MeshDistance found = distanceBetween({a, Pose{}}, {b, pose}, *memory_, *front, limits);
    ASSERT_LE(found.measured.distance, truth.measured.distance + kRounding) << query;
    if (found.state == MeshState::exact) {
      Triangle of_b = b.triangles()[found.nearest.b];
      for (Eigen::Vector3d& corner : of_b) {
        corner = pose * corner;
      }
      const double squared = nearestPoints(a.triangles()[found.nearest.a], of_b).squared_distance;
      ASSERT_LE(std::sqrt(squared), truth.measured.distance + limits.tolerance) << query;
    }
  }
}

TEST_F(MeshFrontLaws, queries_allocateNothing) {
  const auto front = std::make_unique<OwnFront>();
  Pose pose = randomPose(random_, 1.0);
  const AllocationGuard guard;
  for (int i = 0; i < 100; ++i) {
    pose = nextPose(pose, 1e-3, random_);
    distanceBetween({trees_[0], Pose{}}, {trees_[1], pose}, *memory_, *front);
  }
  EXPECT_EQ(guard.count(), 0U);
}

}  // namespace
}  // namespace collision_monitor::test::mesh_front_laws
