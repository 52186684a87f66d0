// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/sat/hull_axes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "narrow_phase/distance.h"
#include "narrow_phase/gjk/convex_pair.h"
#include "support/expect_distance.h"
#include "support/random_poses.h"
#include "support/reference/convex_measure.h"
#include "support/sample_meshes.h"

namespace collision_monitor::test {
namespace {

ConvexHull boxHull(const Eigen::Vector3d& half) { return ConvexHull(boxMesh(half).vertices); }

TEST(HullAxes, boxesApart_faceIsTheSeparatingAxis) {
  const ConvexHull cube = boxHull({1, 1, 1});
  const HullAxis found = bestAxis(cube, cube, at(0, 2.5, 0.3));
  EXPECT_NEAR(found.separation, 0.5, 1e-15);
  expectNear(found.direction, Eigen::Vector3d::UnitY(), "direction");
  EXPECT_NE(found.kind, HullAxis::Kind::edges);
}

TEST(HullAxes, crossedEdges_separateWhereNoFaceDoes) {
  const double s = std::sqrt(0.5);
  const ConvexHull cube = boxHull({1, 1, 1});
  const Pose lower{axes({s, 0, s}, {0, 1, 0}), Eigen::Vector3d::Zero()};
  const Pose upper{axes({1, 0, 0}, {0, s, s}), {0, 0, 2.0 * std::sqrt(2.0) + 0.1}};
  const HullAxis found = bestAxis(cube, cube, relativePose(lower, upper));
  EXPECT_EQ(found.kind, HullAxis::Kind::edges);
  EXPECT_NEAR(found.separation, 0.1, 1e-14);
  expectNear(lower.rotation * found.direction, Eigen::Vector3d::UnitZ(), "direction");
}

TEST(HullAxes, randomBoxes_agreeWithTheFifteenAxes) {
  Random random(20260101);
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector3d half_a = randomPoint(random, 0.5).cwiseAbs().array() + 0.01;
    const Eigen::Vector3d half_b = randomPoint(random, 0.5).cwiseAbs().array() + 0.01;
    const Pose a = randomPose(random, 0.3);
    Pose b = randomPose(random, 0.3);
    if (i % 3 == 0) {
      b.rotation =
          Eigen::AngleAxisd(std::pow(10.0, -i / 20.0), randomPoint(random, 1).normalized()) *
          a.rotation;
    }
    const SignedDistance boxes = distanceBetween(Box{half_a}, a, Box{half_b}, b);
    const HullAxis axis = bestAxis(boxHull(half_a), boxHull(half_b), relativePose(a, b));
    if (boxes.distance <= 0.0) {
      EXPECT_NEAR(axis.separation, boxes.distance, 1e-13) << "seed 20260101, pair " << i;
    } else {
      EXPECT_LE(axis.separation, boxes.distance + 1e-13) << "seed 20260101, pair " << i;
      EXPECT_GT(axis.separation, 0.0) << "seed 20260101, pair " << i;
    }
  }
}

TEST(HullAxes, randomHulls_haveTheDepthThatEpaFinds) {
  Random random(20260101);
  int overlaps = 0;
  for (int i = 0; i < 200; ++i) {
    std::vector<Eigen::Vector3d> points[2];
    for (auto& set : points) {
      for (int k = 0; k < 12; ++k) {
        set.push_back(randomPoint(random, 0.5));
      }
    }
    const ConvexHull hull_a(points[0]);
    const ConvexHull hull_b(points[1]);
    const Pose a = randomPose(random, 0.3);
    const Pose b = randomPose(random, 0.3);
    const HullAxis axis = bestAxis(hull_a, hull_b, relativePose(a, b));
    const ConvexDistance found = measureCold(hull_a, a, hull_b, b);
    ASSERT_EQ(found.quality, Quality::exact);
    EXPECT_EQ(axis.separation <= 0.0, found.measured.distance <= 0.0);
    if (axis.separation <= 0.0) {
      ++overlaps;
      EXPECT_NEAR(axis.separation, found.measured.distance, 1e-13) << "seed 20260101, pair " << i;
    }
  }
  EXPECT_GT(overlaps, 100);
}

// More faces than there is memory for, and more edges than are crossed at a time.
TEST(HullAxes, manyFacesAndEdges_haveTheDepthThatEpaFinds) {
  const ConvexHull globe(sphereMesh(1.0, 24).vertices);
  ASSERT_GT(globe.faces().size(), 256U);
  const ConvexHull needle(boxMesh({0.05, 0.05, 3.0}).vertices);
  Random random(20260101);
  for (int i = 0; i < 40; ++i) {
    const Pose a = randomPose(random, 0.2);
    const Pose b = randomPose(random, 0.2);
    const ConvexHull& other = i % 2 == 0 ? globe : needle;
    const HullAxis axis = bestAxis(globe, other, relativePose(a, b));
    const ConvexDistance found = measureCold(globe, a, other, b);
    ASSERT_EQ(found.quality, Quality::exact);
    ASSERT_LT(found.measured.distance, 0.0);
    EXPECT_NEAR(axis.separation, found.measured.distance, 1e-13) << "seed 20260101, pair " << i;
  }
}

TEST(HullAxes, tipUnderAnyOfManyFaces_separatedByThatFace) {
  const ConvexHull globe(sphereMesh(1.0, 24).vertices);
  const ConvexHull spike(
      std::vector<Eigen::Vector3d>{{0, 0, 0}, {0.1, 0, 1}, {-0.1, 0.1, 1}, {-0.1, -0.1, 1}});
  for (std::uint32_t f = 0; f < globe.faces().size(); ++f) {
    const Eigen::Vector3d& normal = globe.faces()[f].normal;
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const std::uint32_t corner : globe.ringOf(f)) {
      middle += globe.vertices()[corner] / static_cast<double>(globe.ringOf(f).size());
    }
    const Pose upright{
        Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), normal).toRotationMatrix(),
        middle - 1e-3 * normal};
    const HullAxis axis = bestAxis(globe, spike, upright);
    EXPECT_NEAR(axis.separation, -1e-3, 1e-14);
    EXPECT_EQ(axis.kind, HullAxis::Kind::face_of_a);
    EXPECT_EQ(axis.feature_of_a, f);
  }
}

}  // namespace
}  // namespace collision_monitor::test
