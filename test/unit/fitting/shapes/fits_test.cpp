// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "fitting/shapes/fit_box.h"
#include "fitting/shapes/fit_capsule.h"
#include "fitting/shapes/fit_rounded_box.h"
#include "fitting/shapes/fit_sphere.h"
#include "support/sample_meshes.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;
using test::boxMesh;
using test::moved;
using test::prismMesh;
using test::randomCloud;
using test::sphereMesh;

TEST(FitSphere, twoPoints_haveTheirMiddle) {
  const PosedShape fit = fitSphere({{0, 0, 0}, {2, 0, 0}});
  EXPECT_NEAR(radiusOf(fit.shape), 1.0, 1e-15);
  EXPECT_TRUE(fit.geometry_from_body.translation.isApprox(Vector3d(1, 0, 0), 1e-15));
}

TEST(FitSphere, obtuseTriangle_isHeldByItsLongestSide) {
  const PosedShape fit = fitSphere({{-2, 0, 0}, {2, 0, 0}, {0, 1, 0}});
  EXPECT_NEAR(radiusOf(fit.shape), 2.0, 1e-14);
}

TEST(FitSphere, regularTriangle_hasItsCircumcircle) {
  const double h = std::sqrt(3.0);
  const PosedShape fit = fitSphere({{-1, 0, 0}, {1, 0, 0}, {0, h, 0}});
  EXPECT_NEAR(radiusOf(fit.shape), 2.0 / h, 1e-14);
}

TEST(FitSphere, cube_hasHalfItsDiagonal) {
  const PosedShape fit = fitSphere(boxMesh({1, 1, 1}).vertices);
  EXPECT_NEAR(radiusOf(fit.shape), std::sqrt(3.0), 1e-14);
  EXPECT_LT(fit.geometry_from_body.translation.norm(), 1e-14);
}

TEST(FitSphere, manyPointsOnASphere_endAndGiveIt) {
  const auto points = moved(sphereMesh(2.0, 40), {0, 0, 0}, {5, 6, 7}).vertices;
  const PosedShape fit = fitSphere(points);
  EXPECT_NEAR(radiusOf(fit.shape), 2.0, 1e-12);
  EXPECT_LT((fit.geometry_from_body.translation - Vector3d(5, 6, 7)).norm(), 1e-12);
}

TEST(FitSphere, samePoints_giveRadiusZero) {
  EXPECT_EQ(radiusOf(fitSphere(Points(7, Vector3d(1, 2, 3))).shape), 0.0);
}

TEST(FitCapsule, twoBallsOfPoints_giveTheCapsuleAroundThem) {
  Points points = moved(sphereMesh(0.1, 32), Eigen::Vector3d::Zero(), {0, 0, 0.4}).vertices;
  for (const auto& point :
       moved(sphereMesh(0.1, 32), Eigen::Vector3d::Zero(), {0, 0, -0.4}).vertices) {
    points.push_back(point);
  }
  TriangleMesh mesh{points, {}};
  const PosedShape fit = fitCapsule(moved(mesh, {0.4, 0.8, -0.2}, {1, 1, 1}).vertices);
  const double exact = volumeOf(Capsule{0.4, 0.1});
  EXPECT_NEAR(volumeOf(fit.shape) / exact, 1.0, 0.005);
  EXPECT_LT((fit.geometry_from_body.translation - Vector3d(1, 1, 1)).norm(), 1e-3);
}

TEST(FitCapsule, prism_cannotBeHeldByLessThanItsOwnRims) {
  // Along the axis, with the best length: r = hypot(R, H - l), and dV/dl = 0 gives the optimum.
  const double radius = 0.05;
  const double half_length = 0.3;
  double least = 1e9;
  for (double l = 0.2; l <= half_length; l += 1e-5) {
    least = std::min(least, volumeOf(Capsule{l, std::hypot(radius, half_length - l)}));
  }
  const PosedShape fit = fitCapsule(prismMesh(radius, half_length, 32).vertices);
  EXPECT_NEAR(volumeOf(fit.shape) / least, 1.0, 1e-3);
}

TEST(FitCapsule, collinearPoints_giveASegment) {
  const PosedShape fit = fitCapsule({{0, 0, 0}, {3, 4, 0}});
  EXPECT_LT(volumeOf(fit.shape), 1e-3);
}

TEST(FitBox, turnedBox_isFoundExactly) {
  for (const double angle : {0.0, 0.1, 0.7, 1.3}) {
    const auto mesh = moved(boxMesh({0.3, 0.1, 0.02}), angle * Vector3d(1, 2, -1), {3, 2, 1});
    const PosedShape fit = fitBox(mesh.vertices);
    EXPECT_NEAR(volumeOf(fit.shape), 8 * 0.3 * 0.1 * 0.02, 1e-9) << angle;
    EXPECT_LT((fit.geometry_from_body.translation - Vector3d(3, 2, 1)).norm(), 1e-6) << angle;
  }
}

TEST(FitBox, regularTetrahedron_hasTheCubeAroundIt) {
  // The tetrahedron on alternate corners of a cube; its least box is that cube.
  const Points points{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  EXPECT_NEAR(volumeOf(fitBox(points).shape), 8.0, 1e-3);
}

TEST(FitRoundedBox, cornersOfARoundedBox_giveItBack) {
  const Vector3d half(0.2, 0.1, 0.05);
  Points points;
  for (const auto& corner : boxMesh(half).vertices) {
    for (const auto& point :
         moved(sphereMesh(0.04, 24), Eigen::Vector3d::Zero(), corner).vertices) {
      points.push_back(point);
    }
  }
  const auto turned = moved({points, {}}, {0.3, 0.2, 0.9}, {0, 0, 1}).vertices;
  const double exact = volumeOf(RoundedBox{half, 0.04});
  EXPECT_NEAR(volumeOf(fitRoundedBox(turned).shape) / exact, 1.0, 0.02);
}

TEST(FitRoundedBox, isNeverLargerThanTheOthers) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const auto points = randomCloud({0.1, 0.05 * seed, 0.2}, 60, seed).vertices;
    const double rounded = volumeOf(fitRoundedBox(points).shape);
    EXPECT_LE(rounded, volumeOf(fitBox(points).shape)) << "seed " << seed;
    EXPECT_LE(rounded, volumeOf(fitCapsule(points).shape)) << "seed " << seed;
    EXPECT_LE(rounded, volumeOf(fitSphere(points).shape)) << "seed " << seed;
  }
}

}  // namespace
}  // namespace collision_monitor
