// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <vector>

#include "support/expect_distance.h"
#include "support/reference/convex_measure.h"
#include "support/sample_meshes.h"

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

ConvexGeometry hullOfBox(const Vector3d& half_extents) {
  return ConvexHull(boxMesh(half_extents).vertices);
}

SignedDistance measure(const ConvexGeometry& a, const Pose& pose_a, const ConvexGeometry& b,
                       const Pose& pose_b) {
  const ConvexDistance found = measureCold(a, pose_a, b, pose_b);
  EXPECT_EQ(found.quality, Quality::exact);
  expectConsistent(found.measured);
  return found.measured;
}

Pose turned(double angle, const Vector3d& axis, const Pose& pose) {
  return {Eigen::AngleAxisd(angle, axis).toRotationMatrix(), pose.translation};
}

void expectBothAt(const SignedDistance& found, const Vector3d& middle, double distance) {
  const Vector3d half_way(0.0, 0.0, 0.5 * distance);
  EXPECT_NEAR(found.distance, distance, kExact);
  expectNear(found.point_on_a, middle - half_way, "point on a");
  expectNear(found.point_on_b, middle + half_way, "point on b");
}

class FlatContacts : public testing::Test {
 protected:
  const ConvexGeometry table_ = hullOfBox({1, 1, 0.5});  // its top is at 0
  const Pose world_from_table_ = at(0, 0, -0.5);
  const ConvexGeometry cube_ = hullOfBox({0.1, 0.1, 0.1});
};

TEST_F(FlatContacts, cubeOverATable_middleOfTheCube) {
  expectBothAt(measure(table_, world_from_table_, cube_, at(0.3, -0.4, 0.35)), {0.3, -0.4, 0.125},
               0.25);
  expectBothAt(measure(table_, world_from_table_, cube_, at(0.3, -0.4, 0.1)), {0.3, -0.4, 0}, 0.0);
  expectBothAt(measure(table_, world_from_table_, cube_, at(0.3, -0.4, 0.075)),
               {0.3, -0.4, -0.0125}, -0.025);
}

// From the second step on the faces are known, and proven instead of searched.
TEST_F(FlatContacts, cubeThatSlidesOverATable_middleOfTheCubeInEachStep) {
  static ConvexWorkspace workspace;
  ConvexWarmStart warm;
  ConvexSearch search{workspace, warm};
  for (const double x : {0.3, 0.35, 0.4, 0.95}) {
    const ConvexDistance found =
        signedDistanceBetween(table_, world_from_table_, cube_, at(x, -0.4, 0.35), search);
    EXPECT_EQ(found.quality, Quality::exact);
    const double middle = x < 0.9 ? x : 0.925;  // the cube sticks out by half of its half
    expectBothAt(found.measured, {middle, -0.4, 0.125}, 0.25);
  }
}

// The edge of a roof along y below the ridge of another, of which half lies over it.
TEST_F(FlatContacts, ridgesThatSlide_middleOfWhatTheyShare) {
  const ConvexGeometry roof =
      ConvexHull({{-1, -1, -1}, {1, -1, -1}, {0, -1, 0}, {-1, 1, -1}, {1, 1, -1}, {0, 1, 0}});
  const ConvexGeometry keel =
      ConvexHull({{-1, -1, 1}, {1, -1, 1}, {0, -1, 0}, {-1, 1, 1}, {1, 1, 1}, {0, 1, 0}});
  static ConvexWorkspace workspace;
  ConvexWarmStart warm;
  ConvexSearch search{workspace, warm};
  for (const double y : {0.8, 0.9, 1.0}) {
    const ConvexDistance found = signedDistanceBetween(roof, Pose{}, keel, at(0, y, 0.25), search);
    expectBothAt(found.measured, {0, 0.5 * y, 0.125}, 0.25);
  }
}

TEST_F(FlatContacts, swapped_theSamePoints) {
  const SignedDistance ab = measure(table_, world_from_table_, cube_, at(0.3, -0.4, 0.35));
  const SignedDistance ba = measure(cube_, at(0.3, -0.4, 0.35), table_, world_from_table_);
  expectNear(ba.point_on_a, ab.point_on_b, "point on a");
  expectNear(ba.point_on_b, ab.point_on_a, "point on b");
}

TEST_F(FlatContacts, cubeOverTheEdge_middleOfWhatIsLeft) {
  // From 0.95 to 1 along x, all of 0.2 along y.
  expectBothAt(measure(table_, world_from_table_, cube_, at(1.05, 0.2, 0.2)), {0.975, 0.2, 0.05},
               0.1);
}

TEST_F(FlatContacts, cubeTurnedByAnEighth_centroidOfTheTriangleThatIsLeft) {
  // Its corner is 0.06 inside: a triangle whose centroid is a third of that from its base.
  const double reach = 0.1 * std::sqrt(2.0);
  const Pose pose = turned(M_PI / 4, Vector3d::UnitZ(), at(1.0 + reach - 0.06, 0.2, 0.2));
  expectBothAt(measure(table_, world_from_table_, cube_, pose), {0.98, 0.2, 0.05}, 0.1);
}

TEST_F(FlatContacts, boxOnAHull_middle) {
  expectBothAt(measure(table_, world_from_table_, Box{{0.2, 0.1, 0.1}}, at(0.9, 0, 0.2)),
               {0.85, 0, 0.05}, 0.1);
}

TEST_F(FlatContacts, cylinderThatStandsOrLies_middle) {
  const ConvexGeometry cylinder = Cylinder{0.3, 0.1};
  expectBothAt(measure(table_, world_from_table_, cylinder, at(0.2, 0.1, 0.4)), {0.2, 0.1, 0.05},
               0.1);
  const Pose lying = turned(M_PI / 2, Vector3d::UnitY(), at(0.9, 0.1, 0.2));  // from 0.6 to 1.2
  expectBothAt(measure(table_, world_from_table_, cylinder, lying), {0.8, 0.1, 0.05}, 0.1);
}

TEST_F(FlatContacts, capsuleThatLies_middle) {
  const Pose lying = turned(M_PI / 2, Vector3d::UnitY(), at(0.9, 0.1, 0.2));
  expectBothAt(measure(table_, world_from_table_, Capsule{0.3, 0.1}, lying), {0.8, 0.1, 0.05}, 0.1);
}

TEST(FlatContactsOfEdges, roofsOverEachOther_middleOfTheSharedRidge) {
  const auto roof = [](double ridge, double base) {
    return ConvexGeometry(ConvexHull({{-1, -1, base},
                                      {-1, 1, base},
                                      {-1, 0, ridge},
                                      {1, -1, base},
                                      {1, 1, base},
                                      {1, 0, ridge}}));
  };
  const ConvexGeometry up = roof(0, -1);
  const ConvexGeometry down = roof(0, 1);
  // Ridges along x from -1 to 1 and from -0.5 to 1.5.
  expectBothAt(measure(up, {}, down, at(0.5, 0, 0.1)), {0.25, 0, 0.05}, 0.1);
  // Crossed ridges have one point.
  expectBothAt(measure(up, {}, down, turned(1.0, Vector3d::UnitZ(), at(0.5, 0, 0.1))),
               {0.5, 0, 0.05}, 0.1);
}

TEST_F(FlatContacts, slidingAndTurning_pointsDoNotJump) {
  const double step = 1e-3;
  Vector3d last;
  for (int i = 0; i < 1500; ++i) {
    const Pose pose = turned(step * i, Vector3d::UnitZ(), at(step * i - 0.3, 0.3, 0.15));
    const Vector3d point = measure(table_, world_from_table_, cube_, pose).point_on_b;
    // The cube's farthest corner is 0.15 from its middle.
    EXPECT_LE(i == 0 ? 0.0 : (point - last).norm(), 1.2 * step) << "at step " << i;
    last = point;
    if (pose.translation.x() > 1.05) {
      break;
    }
  }
}

}  // namespace
}  // namespace collision_monitor::test
