// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "narrow_phase/distance.h"
#include "support/allocation_guard.h"
#include "support/expect_distance.h"
#include "support/reference/convex_measure.h"

namespace collision_monitor::test {
namespace {

ConvexHull cubeHull(double half) {
  std::vector<Eigen::Vector3d> points;
  for (const double x : {-half, half}) {
    for (const double y : {-half, half}) {
      for (const double z : {-half, half}) {
        points.emplace_back(x, y, z);
      }
    }
  }
  return ConvexHull(points);
}

// Corners at distance 1 along the axes.
ConvexHull octahedron() {
  return ConvexHull({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}});
}

void expectExact(const ConvexDistance& found, double distance, double tolerance = kExact) {
  EXPECT_EQ(found.quality, Quality::exact);
  EXPECT_NEAR(found.measured.distance, distance, tolerance);
  expectConsistent(found.measured);
}

TEST(HullHull, cubesApart_faceToFace) {
  const ConvexDistance found = measureCold(cubeHull(1), Pose{}, cubeHull(1), at(3.5, 0, 0));
  expectExact(found, 1.5);
  expectNear(found.measured.normal_a_to_b, Eigen::Vector3d::UnitX(), "normal");
}

TEST(HullHull, cubesApart_cornerToCorner) {
  expectExact(measureCold(cubeHull(1), Pose{}, cubeHull(1), at(3, 4, 4)), 3.0);
}

TEST(HullHull, cubesOverlap_depthIsTheShortWayOut) {
  const ConvexDistance found = measureCold(cubeHull(1), Pose{}, cubeHull(1), at(1.75, 0.25, 0.5));
  expectExact(found, -0.25);
  expectNear(found.measured.normal_a_to_b, Eigen::Vector3d::UnitX(), "normal");
}

TEST(HullHull, concentricCubes_depthIsTwoHalves) {
  expectExact(measureCold(cubeHull(1), Pose{}, cubeHull(1), Pose{}), -2.0);
}

TEST(HullHull, touchingCubes_distanceIsZero) {
  expectExact(measureCold(cubeHull(1), Pose{}, cubeHull(1), at(2, 0.5, 0)), 0.0);
  expectExact(measureCold(cubeHull(1), Pose{}, cubeHull(1), at(2, 2, 0.5)), 0.0);
  expectExact(measureCold(cubeHull(1), Pose{}, cubeHull(1), at(2, 2, 2)), 0.0);
}

// An edge along y at height sqrt(2) below meets one along x above: the two are 0.1 apart in z.
TEST(HullHull, crossedEdges_distanceIsAlongTheCrossProduct) {
  const double s = std::sqrt(0.5);
  const Pose lower{axes({s, 0, s}, {0, 1, 0}), Eigen::Vector3d::Zero()};
  const Pose upper{axes({1, 0, 0}, {0, s, s}), {0, 0, 2.0 * std::sqrt(2.0) + 0.1}};
  const ConvexDistance apart = measureCold(cubeHull(1), lower, cubeHull(1), upper);
  expectExact(apart, 0.1);
  expectNear(apart.measured.normal_a_to_b, Eigen::Vector3d::UnitZ(), "normal");
  Pose sunk = upper;
  sunk.translation.z() -= 0.15;
  expectExact(measureCold(cubeHull(1), lower, cubeHull(1), sunk), -0.05);
}

TEST(SphereHull, besideFace_insideAndOut) {
  const double third = 1.0 / std::sqrt(3.0);
  expectExact(measureCold(Sphere{0.25}, Pose{}, octahedron(), Pose{}), -third - 0.25);
  const ConvexDistance apart = measureCold(Sphere{0.25}, at(1, 1, 1), octahedron(), Pose{});
  expectExact(apart, 2.0 * third - 0.25);
  expectNear(apart.measured.normal_a_to_b, Eigen::Vector3d::Constant(-third), "normal");
  expectExact(measureCold(octahedron(), Pose{}, Sphere{0.5}, at(2, 0, 0)), 0.5);
}

TEST(SphereCylinder, capRimAndSide) {
  const Cylinder can{1.0, 0.5};
  expectExact(measureCold(Sphere{0.25}, at(0.25, 0, 2), can, Pose{}), 0.75);
  expectExact(measureCold(Sphere{0.25}, at(3, 0, 0.5), can, Pose{}), 2.25);
  expectExact(measureCold(Sphere{0.25}, at(3.5, 0, 5), can, Pose{}), 4.75);  // 3, 4, 5
  expectExact(measureCold(Sphere{0.25}, at(0.25, 0, 0), can, Pose{}), -0.5);
  expectExact(measureCold(Sphere{0.25}, Pose{}, can, Pose{}), -0.75);
}

TEST(CylinderCylinder, coaxial_depthAndGapAreThoseOfAxisOrRadius) {
  const Cylinder can{1.0, 0.5};
  expectExact(measureCold(can, Pose{}, can, at(0, 0, 2.5)), 0.5);
  expectExact(measureCold(can, Pose{}, can, at(1.25, 0, 0)), 0.25);
  expectExact(measureCold(can, Pose{}, can, at(4, 0, 6)), 5.0);
  expectExact(measureCold(can, Pose{}, can, Pose{}), -1.0);
}

// The middle of the lens that two discs share.
TEST(CylinderCylinder, capOnCap_pointIsInTheMiddleOfWhatIsShared) {
  const Cylinder can{1.0, 0.5};
  const ConvexDistance found = measureCold(can, Pose{}, can, at(0.5, 0, 2));
  expectExact(found, 0.0);
  expectNear(found.measured.point_on_a, {0.25, 0, 1}, "point on a");
  expectNear(found.measured.normal_a_to_b, Eigen::Vector3d::UnitZ(), "normal");
}

// Sides that cross: 1 + 0.5 + 0.25 between the axes.
TEST(CylinderCylinder, crossedSides_distanceIsBetweenAxesLessRadii) {
  const Pose across{zToX(), {0, 1.75, 0}};
  const ConvexDistance found = measureCold(Cylinder{2.0, 1.0}, Pose{}, Cylinder{2.0, 0.5}, across);
  expectExact(found, 0.25, 1e-12);
  EXPECT_NEAR(found.measured.normal_a_to_b.y(), 1.0, 1e-9);
  expectExact(measureCold(Cylinder{2.0, 1.0}, Pose{}, Cylinder{2.0, 0.5}, {zToX(), {0, 1.4, 0}}),
              -0.1, 1e-10);
}

// A rim point of the lying can is lowest: the middle of its side line is one of many.
TEST(CylinderCylinder, nearlyParallelAndFar_cutoffZeroDoesNotMakeThemOverlap) {
  Pose far;
  far.translation = {17.445609167352728, 67.487553167358641, 173.21678353553381};
  far.rotation.col(0) << 0.87582261436196007, 0.48263314035836924, -1.6841828532337328e-12;
  far.rotation.col(1) << 0.48263314035836924, -0.87582261436196007, 4.1319696287498208e-13;
  far.rotation.col(2) << -1.2756228818046424e-12, -1.1747297036646543e-12, -1.0;
  ConvexWorkspace workspace;
  ConvexWarmStart warm;
  ConvexSearch search{workspace, warm, 0.0};
  const ConvexDistance found =
      signedDistanceBetween(Cylinder{186.56073867245519, 0.019445113525614253}, far,
                            Cylinder{0.012015946876971521, 0.36595223749718708}, Pose{}, search);
  const double distance = 69.3205501119;
  EXPECT_LE(found.measured.distance, distance + 1e-9);
  EXPECT_TRUE(found.quality != Quality::exact || found.measured.distance > distance - 1e-9);
}

TEST(CylinderHull, lyingOnFace_isHeightLessRadius) {
  expectExact(measureCold(Cylinder{0.5, 0.25}, {zToX(), {0, 0, 1.5}}, cubeHull(1), Pose{}), 0.25,
              1e-11);
  expectExact(measureCold(Cylinder{0.5, 0.25}, {zToX(), {0, 0, 1.125}}, cubeHull(1), Pose{}),
              -0.125, 1e-10);
}

// A can tilted by 45 degrees: its rim reaches (half length + radius) / sqrt(2) below the center.
TEST(CylinderBox, tiltedRimOverFace_distanceIsToTheRim) {
  const double s = std::sqrt(0.5);
  const Pose tilted{axes({s, 0, s}, {0, 1, 0}), {0, 0, 3}};
  const ConvexDistance found = measureCold(Box{{2, 2, 1}}, Pose{}, Cylinder{1.0, 0.5}, tilted);
  expectExact(found, 2.0 - 1.5 * s, 1e-11);
  EXPECT_NEAR(found.measured.normal_a_to_b.z(), 1.0, 1e-12);
}

TEST(CapsuleHull, insideAlongTheMiddle_depthCountsRadius) {
  expectExact(measureCold(Capsule{5.0, 0.25}, Pose{}, cubeHull(1), Pose{}), -1.25);
}

TEST(HalfSpace, everyKind_lowestPointCounts) {
  const Pose ground = Pose{};
  expectExact(measureCold(Sphere{0.5}, at(3, 4, 2), HalfSpace{}, ground), 1.5);
  expectExact(measureCold(Capsule{1.0, 0.25}, at(0, 0, 2), HalfSpace{}, ground), 0.75);
  expectExact(measureCold(RoundedBox{{1, 1, 0.5}, 0.25}, at(0, 0, 0.5), HalfSpace{}, ground),
              -0.25);
  expectExact(measureCold(Cylinder{1.0, 0.5}, {zToX(), {0, 0, 2}}, HalfSpace{}, ground), 1.5);
  expectExact(measureCold(octahedron(), at(0, 0, -2), HalfSpace{}, ground), -3.0);
}

TEST(HalfSpace, flatContact_pointIsInTheMiddleOfTheFace) {
  const ConvexDistance box = measureCold(Box{{1, 2, 3}}, at(5, 6, 3), HalfSpace{}, Pose{});
  expectDistance(box.measured, 0.0, -Eigen::Vector3d::UnitZ(), {5, 6, 0});
  const ConvexDistance hull = measureCold(HalfSpace{}, Pose{}, cubeHull(1), at(5, 6, 2));
  expectDistance(hull.measured, 1.0, Eigen::Vector3d::UnitZ(), {5, 6, 0});
}

TEST(HalfSpace, tiltedPlane_isMeasuredAlongItsNormal) {
  const double s = std::sqrt(0.5);
  const Pose slope{axes({s, 0, -s}, {0, 1, 0}), {1, 0, 0}};  // normal (s, 0, s)
  expectExact(measureCold(Sphere{0.5}, at(3, 0, 0), HalfSpace{}, slope), 2.0 * s - 0.5);
}

TEST(ConvexDistance, twoHalfSpacesOrAPoseThatIsNotFinite_areUnknown) {
  EXPECT_EQ(measureCold(HalfSpace{}, Pose{}, HalfSpace{}, at(0, 0, 1)).quality, Quality::unknown);
  Pose bad;
  bad.translation.x() = std::nan("");
  EXPECT_EQ(measureCold(cubeHull(1), bad, Sphere{1}, Pose{}).quality, Quality::unknown);
  EXPECT_EQ(measureCold(Sphere{1}, Pose{}, Sphere{1}, bad).quality, Quality::unknown);
}

TEST(ConvexDistance, shapesOfTheFamily_areMeasuredByTheirClosedForms) {
  const SignedDistance closed =
      distanceBetween(Capsule{1, 0.25}, Pose{}, RoundedBox{{1, 1, 1}, 0.5}, at(2, 1, 0));
  const ConvexDistance found =
      measureCold(Capsule{1, 0.25}, Pose{}, RoundedBox{{1, 1, 1}, 0.5}, at(2, 1, 0));
  EXPECT_EQ(found.measured.distance, closed.distance);
  EXPECT_EQ(found.quality, Quality::exact);
}

TEST(ConvexDistance, fartherThanEnough_isALowerBound) {
  ConvexWorkspace workspace;
  ConvexWarmStart warm;
  ConvexSearch search{workspace, warm, 0.5};
  const Pose far = at(10, 1, 2);
  const ConvexDistance found =
      signedDistanceBetween(cubeHull(1), Pose{}, Cylinder{1, 1}, far, search);
  EXPECT_EQ(found.quality, Quality::lower_bound);
  EXPECT_GE(found.measured.distance, 0.5);
  EXPECT_LE(found.measured.distance,
            measureCold(cubeHull(1), Pose{}, Cylinder{1, 1}, far).measured.distance);
}

TEST(ConvexDistance, warmStartOfAnotherPose_changesNoAnswer) {
  ConvexWorkspace workspace;
  ConvexWarmStart warm;
  ConvexSearch search{workspace, warm};
  for (const double x : {3.0, 2.5, 1.0, 0.0, -2.5, 8.0}) {
    const Pose pose{eighthTurn(), {x, 0.1, 0.2}};
    const ConvexDistance hot =
        signedDistanceBetween(octahedron(), Pose{}, cubeHull(1), pose, search);
    const ConvexDistance cold = measureCold(octahedron(), Pose{}, cubeHull(1), pose);
    EXPECT_NEAR(hot.measured.distance, cold.measured.distance, 1e-14);
    EXPECT_EQ(hot.quality, Quality::exact);
  }
}

TEST(ConvexDistance, flatAndPointHullsThatCross_haveDepthZero) {
  const ConvexHull square({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}});
  expectExact(measureCold(square, Pose{}, square, at(0.5, 0.5, 0)), 0.0);
  expectExact(measureCold(square, Pose{}, square, at(3, 0, 0)), 1.0);
  const ConvexHull point({{0, 0, 0}});
  expectExact(measureCold(point, Pose{}, point, Pose{}), 0.0);
  expectExact(measureCold(point, Pose{}, point, at(0, 3, 4)), 5.0);
  const ConvexHull line({{-1, 0, 0}, {1, 0, 0}});
  expectExact(measureCold(line, Pose{}, line, {eighthTurn(), Eigen::Vector3d::Zero()}), 0.0);
  expectExact(measureCold(line, Pose{}, square, Pose{}), 0.0);
}

TEST(ConvexDistance, search_doesNotAllocate) {
  const ConvexGeometry hull = octahedron();
  const ConvexGeometry can = Cylinder{1.0, 0.5};
  ConvexWorkspace workspace;
  ConvexWarmStart warm;
  ConvexSearch search{workspace, warm};
  const AllocationGuard guard;
  for (const double x : {3.0, 1.0, 0.1}) {
    signedDistanceBetween(hull, Pose{}, can, {zToX(), {x, 0.1, 0.2}}, search);
  }
  EXPECT_EQ(guard.count(), 0U);
}

}  // namespace
}  // namespace collision_monitor::test
