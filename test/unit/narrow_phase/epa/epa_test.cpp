// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/epa/epa.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "geometry/constants.h"
#include "narrow_phase/gjk/gjk.h"
#include "support/expect_distance.h"

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

const ConvexCore kPointCore{};
const ConvexCore kCubeCore{ConvexCore::Kind::box, {1, 1, 1}};

/// A stands at the origin, B at `place`; GJK gives the simplex to begin with.
Penetration penetrationOf(const ConvexCore& a, const ConvexCore& b, const Vector3d& place) {
  ConvexPair pair = makeConvexPair(a, Pose(), b, {Eigen::Matrix3d::Identity(), place});
  const GjkResult overlap = runGjk(pair, ConvexWarmStart(), {});
  EXPECT_EQ(overlap.state, GjkResult::State::overlapping);
  const auto polytope = std::make_unique<ConvexWorkspace>();
  return runEpa(pair, overlap.simplex, roundingOf(pair), *polytope);
}

TEST(Epa, cubesThatOverlap_shortestWayOutAndItsPoints) {
  const Vector3d place(1.75, 0.25, 0.5);
  const Penetration found = penetrationOf(kCubeCore, kCubeCore, place);
  EXPECT_TRUE(found.is_settled);
  EXPECT_NEAR(found.depth, 0.25, kExact);
  expectNear(found.outward, -Vector3d::UnitX(), "outward: B leaves against it");
  EXPECT_NEAR(found.on_a.x(), 1.0, kExact);
  EXPECT_NEAR(found.on_b.x(), -1.0, kExact) << "in B's frame";
  expectNear(found.on_b + place - found.on_a, found.depth * found.outward, "from point to point");
  EXPECT_EQ(found.face_size, 3);
}

TEST(Epa, cubesOfOneCenter_twoHalves) {
  const Penetration found = penetrationOf(kCubeCore, kCubeCore, Vector3d::Zero());
  EXPECT_TRUE(found.is_settled);
  EXPECT_NEAR(found.depth, 2.0, kExact);
}

TEST(Epa, cubesThatTouch_depthIsZero) {
  const Penetration found = penetrationOf(kCubeCore, kCubeCore, {2, 0.5, 0.25});
  EXPECT_TRUE(found.is_settled);
  EXPECT_NEAR(found.depth, 0.0, kExact);
}

TEST(Epa, pointInACube_asFarAsTheNearestFace) {
  const Penetration found = penetrationOf(kCubeCore, kPointCore, {0.5, -0.875, 0.25});
  EXPECT_NEAR(found.depth, 0.125, kExact);
  expectNear(found.outward, Vector3d::UnitY(), "outward");
  expectNear(found.on_a, {0.5, -1, 0.25}, "point on a");
}

TEST(Epa, pointInAnOctahedron_asFarAsAFace) {
  const ConvexHull solid({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}});
  const ConvexCore hull{ConvexCore::Kind::hull, Vector3d::Zero(), &solid};
  const Penetration found = penetrationOf(hull, kPointCore, {0.25, 0.25, 0.25});
  EXPECT_NEAR(found.depth, 0.25 / std::sqrt(3.0), kExact);
  expectNear(found.on_a, Vector3d::Ones() / 3.0, "point on a");
}

TEST(Epa, pointInACylinder_acrossItsSide) {
  const ConvexCore cylinder{ConvexCore::Kind::cylinder, {1, 1, 2}};
  const Penetration found = penetrationOf(cylinder, kPointCore, {0.375, 0.5, 0.25});
  EXPECT_TRUE(found.is_settled);
  EXPECT_NEAR(found.depth, 0.375, 1e-9) << "1 less 0.625";
}

TEST(Epa, segmentsThatCross_haveNoVolumeAndNoDepth) {
  const ConvexCore along_x{ConvexCore::Kind::box, {1, 0, 0}};
  const ConvexCore along_y{ConvexCore::Kind::box, {0, 1, 0}};
  const Penetration found = penetrationOf(along_x, along_y, {0.25, 0.5, 0});
  EXPECT_TRUE(found.is_settled);
  EXPECT_EQ(found.depth, 0.0);
  EXPECT_EQ(found.face_size, 0);
  EXPECT_NEAR(std::abs(found.outward.z()), 1.0, kExact) << "across both";
}

}  // namespace
}  // namespace collision_monitor::test
