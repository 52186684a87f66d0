// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>

#include "narrow_phase/mesh/mesh_distance.h"
#include "narrow_phase/mesh_front/front_entries.h"
#include "support/expect_distance.h"
#include "support/own_front.h"
#include "support/query_meshes.h"
#include "support/sample_meshes.h"

namespace collision_monitor::test {
namespace {

class MeshFronts : public testing::Test {
 protected:
  /// Of `a` at the origin.
  MeshDistance distance(const MeshTree& a, const MeshTree& b, const Pose& world_from_b,
                        const MeshQueryLimits& limits = MeshQueryLimits{}) {
    return distanceBetween({a, at(0, 0, 0)}, {b, world_from_b}, *memory_, *front_, limits);
  }

  std::unique_ptr<MeshQueryMemory> memory_ = std::make_unique<MeshQueryMemory>();
  std::unique_ptr<OwnFront> front_ = std::make_unique<OwnFront>();
  const MeshTree cube_{boxMesh({1, 1, 1}), true};
  const MeshTree small_{boxMesh({0.1, 0.1, 0.1}), true};
  const MeshTree bumpy_{bumpyMesh(1.0, 40), true};
};

TEST_F(MeshFronts, cubeThatComesNearer_exactInEachStep) {
  for (int step = 0; step < 200; ++step) {
    const double x = 5.0 - 0.01 * step;
    const MeshDistance found = distance(cube_, cube_, at(x, 0, 0));
    ASSERT_EQ(found.state, MeshState::exact);
    ASSERT_NEAR(found.measured.distance, x - 2.0, kExact);
    expectConsistent(found.measured);
  }
}

TEST_F(MeshFronts, trianglesAlmostAsNearAsTheNearest_noShortfall) {
  constexpr double kHigher = 4e-9;
  const TriangleMesh one{{{-1, 0, 0}, {-0.5, 0, 0}, {-0.75, 0.5, 0}}, {{0, 1, 2}}};
  const TriangleMesh other{{{1, 0, 0}, {0.5, 0, 0}, {0.75, 0.5, 0}}, {{0, 1, 2}}};
  const MeshTree level(test::joined(one, other));
  const MeshTree stepped(test::joined(one, moved(other, {0, 0, 0}, {0, 0, -kHigher})));
  for (int step = 0; step < 50; ++step) {
    const double height = 0.1 + 1e-9 * step;
    const MeshDistance found = distance(stepped, level, at(0, 0, height));
    EXPECT_NEAR(found.measured.distance, height, 1e-15) << step;
    EXPECT_EQ(found.shortfall, 0.0) << step;
  }
}

TEST_F(MeshFronts, smallSteps_lookAtAFractionOfWhatTheRootsHave) {
  std::uint32_t from_front = 0;
  std::uint32_t from_roots = 0;
  for (int step = 0; step < 20; ++step) {
    const Pose pose = at(0.3 + 1e-4 * step, 0.73, 0.1);
    from_front += distance(bumpy_, bumpy_, pose).visits;
    from_roots += distanceBetween({bumpy_, at(0, 0, 0)}, {bumpy_, pose}, *memory_).visits;
  }
  EXPECT_LT(3 * from_front, from_roots);
}

TEST_F(MeshFronts, jump_isSeen) {
  EXPECT_NEAR(distance(cube_, small_, at(3, 0, 0)).measured.distance, 1.9, kExact);
  EXPECT_NEAR(distance(cube_, small_, at(2.99, 0, 0)).measured.distance, 1.89, kExact);
  EXPECT_NEAR(distance(cube_, small_, at(0, -1.2, 0)).measured.distance, 0.1, kExact);
  EXPECT_NEAR(distance(cube_, small_, at(0, 0, 4)).measured.distance, 2.9, kExact);
}

TEST_F(MeshFronts, intoTheSolidAndOutAgain_overlapWhileInside) {
  EXPECT_EQ(distance(cube_, small_, at(2, 0, 0)).state, MeshState::exact);
  for (int repeat = 0; repeat < 3; ++repeat) {
    const MeshDistance inside = distance(cube_, small_, at(0.3 + 0.01 * repeat, 0, 0));
    EXPECT_EQ(inside.state, MeshState::overlapping);
    EXPECT_EQ(inside.measured.distance, 0.0);
  }
  EXPECT_EQ(distance(cube_, small_, at(1.05, 0, 0)).state, MeshState::overlapping);
  EXPECT_NEAR(distance(cube_, small_, at(1.2, 0, 0)).measured.distance, 0.1, kExact);
}

TEST_F(MeshFronts, poseNotFinite_unknownAndForgetsNothing) {
  distance(cube_, small_, at(3, 0, 0));
  const Pose bad = at(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  EXPECT_EQ(distance(cube_, small_, bad).state, MeshState::unknown);
  EXPECT_NEAR(distance(cube_, small_, at(2, 0, 0)).measured.distance, 0.9, kExact);
}

TEST_F(MeshFronts, searchThatTheBudgetEnds_goesOnInTheNext) {
  const Pose pose = at(1.1, 0.05, 0.02);
  const double truth =
      distanceBetween({bumpy_, at(0, 0, 0)}, {bumpy_, pose}, *memory_).measured.distance;
  MeshQueryLimits limits;
  limits.visit_budget = 40;
  MeshDistance found = distance(bumpy_, bumpy_, pose, limits);
  ASSERT_EQ(found.state, MeshState::lower_bound);
  double bound = 0.0;
  for (int query = 0; query < 100 && found.state != MeshState::exact; ++query) {
    EXPECT_GE(found.measured.distance, bound) << "what is proven stays";
    EXPECT_LE(found.measured.distance, truth);
    EXPECT_LE(found.visits, limits.visit_budget + 2) << "triangles are measured to the end";
    bound = found.measured.distance - 1e-6;  // a rounding of the bounds
    found = distance(bumpy_, bumpy_, pose, limits);
  }
  EXPECT_EQ(found.state, MeshState::exact);
  EXPECT_NEAR(found.measured.distance, truth, kExact);
}

TEST_F(MeshFronts, limitThatGrows_findsWhatItHid) {
  MeshQueryLimits limits;
  limits.stop_beyond = 0.5;
  const MeshDistance beyond = distance(cube_, small_, at(3, 0, 0), limits);
  EXPECT_EQ(beyond.state, MeshState::lower_bound);
  EXPECT_EQ(beyond.measured.distance, 0.5);
  limits.stop_beyond = 2.5;
  const MeshDistance found = distance(cube_, small_, at(3, 0, 0), limits);
  EXPECT_EQ(found.state, MeshState::exact);
  EXPECT_NEAR(found.measured.distance, 1.9, kExact);
}

/// Farther than bounds reach, and back.
TEST_F(MeshFronts, fartherThanIsKept_isForgottenOnTheWayBack) {
  for (const double far : {1e14, 2e15, 1e16}) {
    distance(cube_, small_, at(far, 0, 0));
    EXPECT_NEAR(distance(cube_, small_, at(1.3, 0, 0)).measured.distance, 0.2, kExact) << far;
    const ConvexGeometry ball = Sphere{0.1};
    const auto solid_front = std::make_unique<OwnFront>();
    distanceBetween({cube_, at(0, 0, 0)}, PlacedConvex{ball, at(far, 0, 0)}, *memory_,
                    *solid_front);
    const MeshDistance inside = distanceBetween(
        {cube_, at(0, 0, 0)}, PlacedConvex{ball, at(0.5, 0, 0)}, *memory_, *solid_front);
    EXPECT_NEAR(inside.measured.distance, -0.6, kExact) << far;
  }
}

/// A tube without ends, and beside the bar in it a flange that is nearest at first.
TEST_F(MeshFronts, nearestPointThatGoesIntoAnOpenMesh_isAsked) {
  TriangleMesh tube = boxMesh({0.06, 0.06, 0.3});
  const auto is_end = [&](const auto& t) {
    return tube.vertices[t[0]].z() == tube.vertices[t[1]].z() &&
           tube.vertices[t[0]].z() == tube.vertices[t[2]].z();
  };
  tube.triangles.erase(std::remove_if(tube.triangles.begin(), tube.triangles.end(), is_end),
                       tube.triangles.end());
  const auto first = static_cast<std::uint32_t>(tube.vertices.size());
  for (const double z : {0.9, 1.0}) {
    tube.vertices.emplace_back(0.055, -0.05, z);
    tube.vertices.emplace_back(0.055, 0.05, z);
  }
  tube.triangles.push_back({first, first + 1, first + 3});
  tube.triangles.push_back({first, first + 3, first + 2});
  const MeshTree open = test::openTree(tube);
  const ConvexGeometry bar = Box{{0.01, 0.01, 1.5}};
  for (const double x : {0.0, -0.001, -0.002, -0.004, -0.006, -0.008}) {
    const PlacedConvex placed{bar, at(x, 0, 0)};
    const MeshDistance found = distanceBetween({open, at(0, 0, 0)}, placed, *memory_, *front_);
    const MeshDistance truth = distanceBetween({open, at(0, 0, 0)}, placed, *memory_);
    EXPECT_EQ(found.state, truth.state) << x;
    EXPECT_NEAR(found.measured.distance, truth.measured.distance, kExact) << x;
  }
}

TEST(DirectionFor, boxInTheBoxOfASlantedTriangle_partedAcrossTheEdge) {
  const BoundPlacement resting = makePlacement(Pose{}, 20.0);
  const Triangle triangle{{{10, 0, 0}, {0, 10, 0}, {10, 10, 0}}};
  const MeshTree around(TriangleMesh{{triangle[0], triangle[1], triangle[2]}, {{0, 1, 2}}});
  const MeshTree box(boxMesh({1, 1, 1}));
  OpenedPair opened;
  opened.node = &box.nodes()[0];
  opened.placed = place(makePlacement({Eigen::Matrix3d::Identity(), around.center()}, 20.0),
                        boundAt(around, 0));
  opened.triangle = place(resting, Eigen::Vector3d::Zero(), triangle);
  boundChildren(1e30F, opened);
  const std::uint32_t direction = directionFor(opened, 1U, Eigen::Matrix3d::Identity());
  const auto gaps = gapsAlong(direction, opened, Eigen::Matrix3d::Identity());
  EXPECT_GT(gaps[0], 0.99F * std::sqrt(opened.bounds.squared[0]));
}

}  // namespace
}  // namespace collision_monitor::test
