// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/mesh/mesh_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "support/expect_distance.h"
#include "support/mesh_overlap.h"
#include "support/random_poses.h"
#include "support/sample_meshes.h"

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

/// A disk about the origin, across z, of triangles that share its center.
TriangleMesh fanMesh(double radius, std::uint32_t count) {
  TriangleMesh fan;
  fan.vertices.push_back(Vector3d::Zero());
  for (std::uint32_t i = 0; i < count; ++i) {
    const double angle = 2.0 * M_PI * i / count;
    fan.vertices.push_back({radius * std::cos(angle), radius * std::sin(angle), 0.0});
    fan.triangles.push_back({0, 1 + i, 1 + (i + 1) % count});
  }
  return fan;
}

class Meshes : public testing::Test {
 protected:
  MeshDistance distance(const MeshTree& a, const Pose& world_from_a, const MeshTree& b,
                        const Pose& world_from_b) {
    return distanceBetween({a, world_from_a}, {b, world_from_b}, *memory_);
  }
  bool meet(const MeshTree& a, const Pose& world_from_a, const MeshTree& b,
            const Pose& world_from_b) {
    return meshesOverlap({a, world_from_a}, {b, world_from_b}, *memory_);
  }
  MeshDistance shapeDistance(const MeshTree& a, const Shape& b, const Pose& world_from_b) {
    return distanceBetween({a, at(0, 0, 0)}, {b, world_from_b}, *memory_);
  }

  std::unique_ptr<MeshQueryMemory> memory_ = std::make_unique<MeshQueryMemory>();
  const MeshTree cube_{boxMesh({1, 1, 1}), true};
  const MeshTree small_{boxMesh({0.1, 0.1, 0.1}), true};
};

TEST_F(Meshes, cubesApart_distancePointsAndNormal) {
  const MeshDistance found = distance(cube_, at(0, 0, 0), cube_, at(5, 0, 0));
  EXPECT_EQ(found.state, MeshState::exact);
  EXPECT_NEAR(found.measured.distance, 3.0, kExact);
  EXPECT_NEAR(found.measured.point_on_a.x(), 1.0, kExact);
  expectNear(found.measured.normal_a_to_b, {1, 0, 0}, "normal");
  expectConsistent(found.measured);
  EXPECT_FALSE(meet(cube_, at(0, 0, 0), cube_, at(5, 0, 0)));
}

TEST_F(Meshes, cornersApart_distanceBetweenThem) {
  const MeshDistance found = distance(cube_, at(0, 0, 0), cube_, at(5, 6, 14));
  EXPECT_NEAR(found.measured.distance, 13.0, kExact);  // 3, 4, 12
  expectNear(found.measured.point_on_a, {1, 1, 1}, "point on a");
  expectNear(found.measured.point_on_b, {4, 5, 13}, "point on b");
}

TEST_F(Meshes, trianglesEquallyNear_takeAsLongInEveryPose) {
  constexpr std::uint32_t kCount = 256;
  constexpr double kGap = 1.5e-4;
  const MeshTree fan(fanMesh(0.04, kCount));
  const MeshTree plate(boxMesh({0.1, 0.1, 0.01}));
  Random random(1);
  std::uint32_t least = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t most = 0;
  for (int i = 0; i < 20; ++i) {
    const Pose world_from_plate = randomPose(random, 1.0);
    const MeshDistance found =
        distance(plate, world_from_plate, fan, world_from_plate * at(0.02, 0.01, 0.01 + kGap));
    EXPECT_NEAR(found.measured.distance, kGap, 1e-15);
    EXPECT_EQ(found.shortfall, 0.0);
    least = std::min(least, found.visits);
    most = std::max(most, found.visits);
  }
  // Rounding makes many of them look nearer than the first, in some poses. None is measured.
  EXPECT_LE(most, least + 10);
}

TEST_F(Meshes, oneOfTwoPiecesInside_overlap) {
  // The piece outside is nearer to the cube's surface than the one inside.
  const MeshTree pieces(test::joined(moved(boxMesh({0.1, 0.1, 0.1}), {0, 0, 0}, {1.3, 0, 0}),
                                     boxMesh({0.2, 0.2, 0.2})));
  ASSERT_EQ(pieces.pieces().size(), 2U);
  for (const bool swaps : {false, true}) {
    const MeshTree& a = swaps ? pieces : cube_;
    const MeshTree& b = swaps ? cube_ : pieces;
    EXPECT_TRUE(meet(a, at(0, 0, 0), b, at(0, 0, 0)));
    const MeshDistance found = distance(a, at(0, 0, 0), b, at(0, 0, 0));
    EXPECT_EQ(found.state, MeshState::overlapping);
    EXPECT_NEAR(found.measured.point_on_a.cwiseAbs().maxCoeff(), 0.2, kExact);
  }
  const MeshTree open_cube(boxMesh({1, 1, 1}));
  EXPECT_NEAR(distance(open_cube, at(0, 0, 0), pieces, at(0, 0, 0)).measured.distance, 0.2, kExact);
}

TEST_F(Meshes, surfacesCross_overlap) {
  EXPECT_TRUE(meet(cube_, at(0, 0, 0), cube_, at(1.5, 0.3, 0.2)));
  const MeshDistance found = distance(cube_, at(0, 0, 0), cube_, at(1.5, 0.3, 0.2));
  EXPECT_EQ(found.state, MeshState::overlapping);
  EXPECT_EQ(found.measured.distance, 0.0);
}

TEST_F(Meshes, touchingFaces_overlap) {
  EXPECT_TRUE(meet(cube_, at(0, 0, 0), cube_, at(2, 0, 0)));
  EXPECT_EQ(distance(cube_, at(0, 0, 0), cube_, at(2, 0, 0)).state, MeshState::overlapping);
}

TEST_F(Meshes, closedMeshInsideAnother_isNotClear) {
  EXPECT_TRUE(meet(cube_, at(0, 0, 0), small_, at(0.3, 0, 0)));
  EXPECT_TRUE(meet(small_, at(0.3, 0, 0), cube_, at(0, 0, 0)));
  EXPECT_EQ(distance(cube_, at(0, 0, 0), small_, at(0.3, 0, 0)).state, MeshState::overlapping);
  EXPECT_EQ(distance(small_, at(0.3, 0, 0), cube_, at(0, 0, 0)).state, MeshState::overlapping);
}

TEST_F(Meshes, insideOutMesh_stillHasAnInside) {
  TriangleMesh mesh = boxMesh({1, 1, 1});
  for (auto& triangle : mesh.triangles) {
    std::swap(triangle[0], triangle[1]);
  }
  EXPECT_TRUE(meet(MeshTree(mesh, true), at(0, 0, 0), small_, at(0.3, 0, 0)));
}

TEST_F(Meshes, lineOfSightThroughEdgesAndCorners_countsRight) {
  // The bottom of the inner box stands exactly below edges and corners of the outer one's top.
  const MeshTree roof(sphereMesh(1.0, 8), true);
  EXPECT_TRUE(meet(roof, at(0, 0, 0), MeshTree(boxMesh({0.1, 0.1, 0.1}), true), at(0.1, 0.1, 0)));
  EXPECT_FALSE(meet(roof, at(0, 0, 0), small_, at(0.1, 0.1, -3)));
  EXPECT_FALSE(meet(roof, at(0, 0, 0), small_, at(0.1, 0.1, 3)));
}

TEST_F(Meshes, openMeshAroundAnother_isApart) {
  const MeshTree surface(boxMesh({1, 1, 1}), false);
  EXPECT_FALSE(meet(surface, at(0, 0, 0), small_, at(0.3, 0, 0)));
  const MeshDistance found = distance(surface, at(0, 0, 0), small_, at(0.3, 0, 0));
  EXPECT_EQ(found.state, MeshState::exact);
  EXPECT_NEAR(found.measured.distance, 0.6, kExact);
}

TEST_F(Meshes, poseNotFinite_isUnknownAndNotClear) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const Pose pose = at(bad, 0, 0);
    const MeshDistance found = distance(cube_, pose, cube_, at(5, 0, 0));
    EXPECT_EQ(found.state, MeshState::unknown);
    EXPECT_TRUE(std::isfinite(found.measured.distance));
    EXPECT_TRUE(found.measured.point_on_a.allFinite());
    EXPECT_TRUE(meet(cube_, at(5, 0, 0), cube_, pose));
    EXPECT_EQ(shapeDistance(cube_, Sphere{0.1}, pose).state, MeshState::unknown);
  }
}

TEST_F(Meshes, oneTriangleOnePointAndEqualVertices_areLegal) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 1}, {1, 2, 3}, {1, 2, 3}, {0, 0, 0}};
  const MeshTree doubled(mesh);
  EXPECT_NEAR(distance(doubled, at(0, 0, 0), cube_, at(0.2, 0.2, 4)).measured.distance, 3.0,
              kExact);
  mesh.triangles = {{1, 2, 3}};
  const MeshTree one(mesh);
  EXPECT_NEAR(distance(one, at(0, 0, 0), one, at(0, 0, 2)).measured.distance, 2.0, kExact);
  mesh.vertices = {{0, 0, 0}};
  mesh.triangles.clear();
  const MeshTree point(mesh);
  EXPECT_NEAR(distance(point, at(0, 0, 0), point, at(0, 3, 4)).measured.distance, 5.0, kExact);
  EXPECT_TRUE(meet(point, at(0, 0, 0), point, at(0, 0, 0)));
}

TEST_F(Meshes, sphereApartTouchingSurfaceAndInside) {
  EXPECT_NEAR(shapeDistance(cube_, Sphere{0.5}, at(4, 0, 0)).measured.distance, 2.5, kExact);
  EXPECT_NEAR(shapeDistance(cube_, Sphere{0.5}, at(1.25, 0, 0)).measured.distance, -0.25, kExact);
  const MeshDistance inside = shapeDistance(cube_, Sphere{0.1}, at(0.75, 0, 0));
  EXPECT_EQ(inside.state, MeshState::overlapping);
  EXPECT_NEAR(inside.measured.distance, -0.35, kExact);
  expectNear(inside.measured.normal_a_to_b, {1, 0, 0}, "normal");
  expectConsistent(inside.measured);
}

TEST_F(Meshes, capsuleBesideAndThroughTheCube) {
  const Capsule capsule{2.0, 0.25};
  const MeshDistance beside = shapeDistance(cube_, capsule, at(3, 0, 0));
  EXPECT_NEAR(beside.measured.distance, 1.75, kExact);
  expectNear(beside.measured.normal_a_to_b, {1, 0, 0}, "normal");
  const MeshDistance through = shapeDistance(cube_, capsule, at(0.2, 0.1, 0));
  EXPECT_EQ(through.state, MeshState::overlapping);
  EXPECT_LE(through.measured.distance, -0.25);
}

TEST_F(Meshes, boxApartCuttingAndAround) {
  EXPECT_NEAR(shapeDistance(cube_, Box{{1, 2, 3}}, at(6, 0, 0)).measured.distance, 4.0, kExact);
  EXPECT_EQ(shapeDistance(cube_, Box{{5, 5, 0.1}}, at(0, 0, 0)).state, MeshState::overlapping);
  EXPECT_EQ(shapeDistance(cube_, Box{{5, 5, 5}}, at(0, 0, 0)).state, MeshState::overlapping);
  const MeshDistance inside = shapeDistance(cube_, Box{{0.5, 0.1, 0.1}}, at(0, 0, 0));
  EXPECT_EQ(inside.state, MeshState::overlapping);
  EXPECT_NEAR(inside.measured.distance, -0.5, kExact);
}

TEST_F(Meshes, insideBeyondTheLimit_isNotClear) {
  MeshQueryLimits limits;
  limits.stop_beyond = 0.01;
  const Shape sphere = Sphere{0.05};
  const MeshDistance found =
      distanceBetween({cube_, at(0, 0, 0)}, {sphere, at(0.1, 0, 0)}, *memory_, {}, limits);
  EXPECT_EQ(found.state, MeshState::overlapping);
  EXPECT_LE(found.measured.distance, -0.05);
  EXPECT_EQ(
      distanceBetween({cube_, at(0, 0, 0)}, {small_, at(0.1, 0, 0)}, *memory_, {}, limits).state,
      MeshState::overlapping);
}

}  // namespace
}  // namespace collision_monitor::test
