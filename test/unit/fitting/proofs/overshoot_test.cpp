// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/fitting/overshoot.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/constants.h"
#include "support/sample_meshes.h"

namespace collision_monitor {
namespace {

using test::boxMesh;
using test::moved;

double areaOf(const Shape& shape) {
  double area = 0.0;
  for (const auto& sample : sampleSurface(shape, 2000)) {
    area += sample.area;
  }
  return area;
}

TEST(SampleSurface, areasAddUpToTheSurface) {
  EXPECT_NEAR(areaOf(Sphere{0.5}), kPi, 0.01 * kPi);
  EXPECT_NEAR(areaOf(Box{{0.5, 1.0, 1.5}}), 22.0, 1e-9);
  const double capsule = 4 * kPi * 0.01 + 2 * kPi * 0.1 * 0.6;
  EXPECT_NEAR(areaOf(Capsule{0.3, 0.1}), capsule, 0.01 * capsule);
  const double rounded = 22.0 + kPi / 2 * 0.1 * 4 * (1.0 + 2.0 + 3.0) + 4 * kPi * 0.01;
  EXPECT_NEAR(areaOf(RoundedBox{{0.5, 1.0, 1.5}, 0.1}), rounded, 0.001 * rounded);
}

TEST(SampleSurface, everySampleIsOnTheSurface) {
  for (const Shape& shape : {Shape(Sphere{0.5}), Shape(Capsule{0.3, 0.1}), Shape(Box{{1, 2, 3}}),
                             Shape(RoundedBox{{0.5, 0.0, 1.5}, 0.1})}) {
    for (const auto& sample : sampleSurface(shape, 500)) {
      EXPECT_NEAR(signedDistanceTo(shape, sample.point), 0.0, 1e-14) << kindName(shape);
    }
  }
}

TEST(SampleSurface, needlesPointsAndSheets_haveAFewSamples) {
  for (const Shape& shape : {Shape(Sphere{0.0}), Shape(Capsule{1.0, 1e-17}), Shape(Box{{1, 0, 0}}),
                             Shape(Box{{1, 1, 1e-17}}), Shape(Capsule{1.0, 0.0})}) {
    const auto samples = sampleSurface(shape, 1000);
    EXPECT_GE(samples.size(), 8u);
    EXPECT_LE(samples.size(), 300000u);
  }
}

TEST(MeasureOvershoot, boxAroundASmallerBox_isTheGapAndItsDiagonal) {
  const TriangleBvh mesh(boxMesh({0.5, 0.5, 0.5}));
  const Overshoot overshoot = measureOvershoot({Box{{0.6, 0.6, 0.6}}, {}}, mesh, {3000, 0.01});
  EXPECT_NEAR(overshoot.max, 0.1 * std::sqrt(3.0), 1e-3 * 0.1);
  EXPECT_GT(overshoot.mean, 0.1);
  EXPECT_LT(overshoot.mean, 0.115);
}

TEST(MeasureOvershoot, sphereAroundACube_isFarthestAboveTheFaces) {
  const TriangleBvh mesh(boxMesh({1, 1, 1}));
  const double radius = std::sqrt(3.0);
  const Overshoot overshoot = measureOvershoot({Sphere{radius}, {}}, mesh, {3000, 0.01});
  EXPECT_NEAR(overshoot.max, radius - 1.0, 0.01 * radius);
}

TEST(MeasureOvershoot, placedShape_isMeasuredWhereItIs) {
  const TriangleMesh box = boxMesh({0.5, 0.5, 0.5});
  PosedShape fit{Box{{0.5, 0.5, 0.5}}, {}};
  fit.geometry_from_body.translation = {3, 0, 0};
  const Overshoot overshoot = measureOvershoot(
      fit, TriangleBvh(moved(box, Eigen::Vector3d::Zero(), {3, 0, 0})), {100, 0.0});
  EXPECT_LT(overshoot.max, 1e-15);
  EXPECT_NEAR(measureOvershoot(fit, TriangleBvh(box), {100, 0.0}).max, 3.0, 1e-12);
}

}  // namespace
}  // namespace collision_monitor
