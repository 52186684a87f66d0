// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "narrow_phase/mesh/mesh_distance.h"
#include "support/allocation_guard.h"
#include "support/expect_distance.h"
#include "support/fixed_seed.h"
#include "support/own_front.h"
#include "support/query_meshes.h"
#include "support/random_pairs.h"
#include "support/sample_meshes.h"

// Whether meshes touch, and distances within a tolerance, against distances that are exact.
namespace collision_monitor::test {
namespace {

using State = MeshContact::State;

class MeshContactLaws : public testing::Test {
 protected:
  MeshTree anyMesh() {
    switch (random_() % 4) {
      case 0:
        return MeshTree(boxMesh({0.2, 0.1, 0.3}), true);
      case 1:
        return MeshTree(bumpyMesh(0.4, 10), true);
      case 2:
        return test::openTree(sphereMesh(0.3, 12));
      default:
        return MeshTree(triangleSoup(0.4, 30, random_));
    }
  }
  /// Near each other, and often one within the other.
  Pose anyPose() { return randomPose(random_, uniform(random_, 0.0, 0.6)); }

  std::unique_ptr<MeshQueryMemory> memory_ = std::make_unique<MeshQueryMemory>();
  Random random_{kSeed};
};

TEST_F(MeshContactLaws, contact_isADistanceNoLarger) {
  int apart = 0;
  int touching = 0;
  TrianglePair start;
  for (int i = 0; i < 600; ++i) {
    const MeshTree a = anyMesh();
    const MeshTree b = anyMesh();
    const Pose at_a = anyPose();
    const Pose at_b = anyPose();
    const MeshDistance truth = distanceBetween({a, at_a}, {b, at_b}, *memory_);
    const double distance = i % 3 == 0 ? 0.0 : uniform(random_, 0.0, 0.2);
    const MeshContact found = contactOf({a, at_a}, {b, at_b}, {distance}, *memory_, start);
    const bool is_contact =
        truth.state == MeshState::overlapping || truth.measured.distance <= distance;
    ASSERT_EQ(found.state, is_contact ? State::contact : State::apart)
        << i << ": " << truth.measured.distance << " and " << distance;
    start = found.triangles;  // of other meshes: it may be any
    ++(is_contact ? touching : apart);
  }
  EXPECT_GT(apart, 100);
  EXPECT_GT(touching, 100);
}

TEST_F(MeshContactLaws, contactOfASolid_isADistanceNoLarger) {
  int touching = 0;
  for (int i = 0; i < 600; ++i) {
    const MeshTree a = anyMesh();
    const Pose at_a = anyPose();
    const Pose at_b = anyPose();
    const ConvexGeometry solids[] = {Sphere{0.1}, Capsule{0.1, 0.05}, Box{{0.1, 0.05, 0.2}},
                                     Cylinder{0.1, 0.1}};
    const ConvexGeometry& b = solids[i % 4];
    const MeshDistance truth = distanceBetween({a, at_a}, PlacedConvex{b, at_b}, *memory_);
    const double distance = i % 3 == 0 ? 0.0 : uniform(random_, 0.0, 0.2);
    if (std::abs(truth.measured.distance - distance) < 1e-9) {
      continue;  // as exact as cylinders are
    }
    const MeshContact found = contactOf({a, at_a}, PlacedConvex{b, at_b}, {distance}, *memory_);
    const bool is_contact =
        truth.state == MeshState::overlapping || truth.measured.distance <= distance;
    ASSERT_EQ(found.state, is_contact ? State::contact : State::apart)
        << i << ": " << truth.measured.distance << " and " << distance;
    touching += is_contact ? 1 : 0;
  }
  EXPECT_GT(touching, 100);
}

/// Less than the exact distance by the tolerance at most, and by half of the distance.
TEST_F(MeshContactLaws, distanceWithinATolerance_isALowerBoundThatIsShortByNoMore) {
  double visits = 0.0;
  double visits_exact = 0.0;
  int short_of = 0;
  for (int walk = 0; walk < 40; ++walk) {
    const MeshTree a = anyMesh();
    const MeshTree b = anyMesh();
    const auto front = std::make_unique<OwnFront>();
    const double tolerance = std::pow(10.0, uniform(random_, -5.0, -2.0));
    const MeshQueryLimits limits{std::numeric_limits<double>::infinity(),
                                 MeshQueryLimits().visit_budget, tolerance};
    Pose at_b = anyPose();
    for (int step = 0; step < 30; ++step) {
      at_b.translation += 0.3 * tolerance * randomPoint(random_, 0.5);
      const MeshDistance truth = distanceBetween({a, Pose()}, {b, at_b}, *memory_);
      for (const bool has_front : {false, true}) {
        const MeshDistance found =
            has_front ? distanceBetween({a, Pose()}, {b, at_b}, *memory_, *front, limits)
                      : distanceBetween({a, Pose()}, {b, at_b}, *memory_, {}, limits);
        ASSERT_EQ(found.state, truth.state);
        ASSERT_LE(found.measured.distance, truth.measured.distance + 1e-12);
        ASSERT_GE(found.measured.distance, truth.measured.distance - tolerance - 1e-12);
        ASSERT_GE(found.measured.distance, 0.5 * truth.measured.distance - 1e-12);
        expectConsistent(found.measured);
        short_of += found.measured.distance < truth.measured.distance - 1e-9 ? 1 : 0;
        visits += found.visits;
      }
      visits_exact += 2.0 * truth.visits;
    }
  }
  EXPECT_GT(short_of, 20) << "the tolerance is used";
  EXPECT_LT(visits, 0.7 * visits_exact);
}

/// What is known before ends searches, and never changes more than the tolerance allows.
TEST_F(MeshContactLaws, knownBounds_endSearchesWithinTheTolerance) {
  constexpr std::uint32_t kTrianglesMeasured = 8;  // visits of one pair at most
  int ended = 0;
  for (int walk = 0; walk < 40; ++walk) {
    const MeshTree a = anyMesh();
    const MeshTree b = anyMesh();
    const auto front = std::make_unique<OwnFront>();
    Pose at_b = anyPose();
    for (int step = 0; step < 30; ++step) {
      at_b.translation += 1e-3 * randomPoint(random_, 0.5);
      const MeshDistance truth = distanceBetween({a, Pose()}, {b, at_b}, *memory_);
      if (truth.state != MeshState::exact) {
        continue;
      }
      MeshQueryLimits limits;
      limits.tolerance = std::pow(10.0, uniform(random_, -4.0, -2.0));
      limits.at_least =
          std::max(0.0, truth.measured.distance - uniform(random_, 0.0, 2.0 * limits.tolerance));
      const MeshDistance found = distanceBetween({a, Pose()}, {b, at_b}, *memory_, *front, limits);
      const MeshDistance from_roots = distanceBetween({a, Pose()}, {b, at_b}, *memory_, {}, limits);
      for (const MeshDistance& one : {found, from_roots}) {
        ASSERT_EQ(one.state, MeshState::exact);
        ASSERT_LE(one.measured.distance, truth.measured.distance + 1e-12);
        ASSERT_GE(one.measured.distance, truth.measured.distance - limits.tolerance - 1e-12);
        ASSERT_GE(one.measured.distance, limits.at_least - 1e-12);
        ASSERT_GE(one.measured.distance + one.shortfall, truth.measured.distance - 1e-12);
        expectConsistent(one.measured);
      }
      const bool is_settled = std::abs(found.measured.distance - limits.at_least) <= 1e-12;
      ended += is_settled && found.visits <= kTrianglesMeasured ? 1 : 0;
    }
  }
  EXPECT_GT(ended, 50);
}

TEST_F(MeshContactLaws, queries_allocateNothing) {
  const MeshTree a = anyMesh();
  const MeshTree b = anyMesh();
  const AllocationGuard guard;
  contactOf({a, Pose()}, {b, Pose()}, {0.01}, *memory_);
  EXPECT_EQ(guard.count(), 0U);
}

}  // namespace
}  // namespace collision_monitor::test
