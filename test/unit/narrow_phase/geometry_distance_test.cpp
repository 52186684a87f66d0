// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/geometry_distance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

#include "support/expect_distance.h"
#include "support/sample_meshes.h"

namespace collision_monitor::test {
namespace {

constexpr double kMeshExact = 1e-9;

/// Centers along x at -2, 0 and 2, radius 0.5, below a root that is too small to hold them.
SphereUnion threeBalls() {
  SphereTree tree;
  tree.nodes.resize(4);
  tree.nodes[0].radius = 1.0;
  tree.nodes[0].first_child = 1;
  tree.nodes[0].child_count = 3;
  for (std::size_t i = 1; i < 4; ++i) {
    tree.nodes[i].center = {2.0 * static_cast<double>(i) - 4.0, 0, 0};
    tree.nodes[i].radius = 0.5;
    tree.nodes[i].level = 1;
  }
  return makeSphereUnion(tree);
}

class GeometryDistance : public testing::Test {
 protected:
  ConvexDistance measure(const GeometryRef& a, const Pose& pose_a, const GeometryRef& b,
                         const Pose& pose_b) {
    ConvexWarmStart warm;
    ConvexSearch convex{workspace_, warm};
    GeometrySearch search{convex, *memory_};
    return signedDistanceBetween(a, pose_a, b, pose_b, search);
  }

  void expectBothWays(const GeometryRef& a, const GeometryRef& b, const Pose& pose_b,
                      double distance, Quality quality = Quality::exact) {
    const ConvexDistance found = measure(a, {}, b, pose_b);
    EXPECT_EQ(found.quality, quality);
    EXPECT_NEAR(found.measured.distance, distance, kMeshExact);
    expectConsistent(found.measured);
    const ConvexDistance swapped = measure(b, pose_b, a, {});
    EXPECT_EQ(swapped.quality, quality);
    EXPECT_NEAR(swapped.measured.distance, distance, kMeshExact);
    expectNear(swapped.measured.normal_a_to_b, -found.measured.normal_a_to_b, "swapped normal");
  }

  ConvexWorkspace workspace_;
  std::unique_ptr<MeshQueryMemory> memory_ = std::make_unique<MeshQueryMemory>();
  MeshTree cube_{boxMesh({1, 1, 1}), true};
  SphereUnion balls_ = threeBalls();
};

TEST_F(GeometryDistance, cubeMeshAndCylinder_sideCapAndEdge) {
  const ConvexGeometry cylinder = Cylinder{0.5, 0.25};
  expectBothWays(&cube_, &cylinder, at(2, 0, 0), 0.75);
  expectBothWays(&cube_, &cylinder, at(0, 0.2, 2), 0.5);
  // The cube's edge at x = 1, z = 1 and the rim at 1.75, 1.5.
  expectBothWays(&cube_, &cylinder, at(2, 0, 2), std::hypot(0.75, 0.5));
  expectBothWays(&cube_, &cylinder, at(1.2, 0, 0), 0.0, Quality::estimate);
}

TEST_F(GeometryDistance, cubeMeshAndHull_cornerToFace) {
  const ConvexGeometry octahedron =
      ConvexHull({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}});
  expectBothWays(&cube_, &octahedron, at(2.5, 0, 0), 0.5);
  // The cube's corner and the face x + y + z = -1 of the octahedron.
  expectBothWays(&cube_, &octahedron, at(2, 2, 2), (3.0 - 1.0) / std::sqrt(3.0));
}

TEST_F(GeometryDistance, hullOffItsOrigin_isFoundWhereItIs) {
  const ConvexGeometry hull =
      ConvexHull({{10, -1, -1}, {12, -1, -1}, {10, 1, -1}, {10, -1, 1}, {12, 1, 1}});
  expectBothWays(&cube_, &hull, Pose{}, 9.0);
}

TEST_F(GeometryDistance, halfSpace_isExactInDepthToo) {
  const ConvexGeometry floor = HalfSpace{};
  expectBothWays(&cube_, &floor, at(0, 0, -1.5), 0.5);
  expectBothWays(&cube_, &floor, at(0, 0, -0.5), -0.5);
  expectBothWays(&balls_, &floor, at(0, 0, -1.5), 1.0);
  expectBothWays(&balls_, &floor, at(0, 0, -0.5 + 0.1), -0.1);
}

TEST_F(GeometryDistance, unionOfSpheres_isItsNearestLeaf) {
  const ConvexGeometry box = Box{{0.5, 0.5, 0.5}};
  expectBothWays(&balls_, &box, at(4, 0, 0), 1.0);
  expectBothWays(&balls_, &box, at(1, 2, 0), std::hypot(0.5, 1.5) - 0.5);
  expectBothWays(&balls_, &box, at(2, 0.8, 0), -0.2, Quality::estimate);
  expectBothWays(&balls_, &cube_, at(4, 0, 0), 0.5);
  expectBothWays(&balls_, &balls_, at(0, 3, 0), 2.0);
  expectBothWays(&balls_, &balls_, at(5.5, 0, 0), 0.5);
}

TEST_F(GeometryDistance, overlappingMeshes_separateWithinTheBound) {
  const ConvexDistance found = measure(&cube_, {}, &cube_, at(1.5, 0, 0));
  EXPECT_EQ(found.quality, Quality::lower_bound);
  EXPECT_NEAR(found.measured.distance, -0.5, kMeshExact);
  expectConsistent(found.measured);
}

TEST_F(GeometryDistance, poseThatIsNotFinite_isUnknown) {
  const Pose lost = at(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  EXPECT_EQ(measure(&cube_, lost, &balls_, {}).quality, Quality::unknown);
}

TEST_F(GeometryDistance, meshBeyondAllReach_isUnknown) {
  const ConvexGeometry box = Box{{1, 1, 1}};
  for (const GeometryRef& other : {GeometryRef(&cube_), GeometryRef(&box)}) {
    EXPECT_EQ(measure(&cube_, {}, other, at(1e16, 0, 0)).quality, Quality::unknown);
    EXPECT_EQ(measure(other, at(0, 1e60, 0), &cube_, {}).quality, Quality::unknown);
  }
}

TEST_F(GeometryDistance, treeWithoutNodes_isNoSolid) {
  EXPECT_THROW(makeSphereUnion({}), std::invalid_argument);
}

}  // namespace
}  // namespace collision_monitor::test
