// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/contact/manifold.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "narrow_phase/distance.h"
#include "support/expect_distance.h"

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

ContactManifold touch(const Shape& a, const Pose& world_from_a, const Shape& b,
                      const Pose& world_from_b) {
  return manifoldBetween(a, world_from_a, b, world_from_b,
                         distanceBetween(a, world_from_a, b, world_from_b));
}

// In any order.
void expectPointsOnA(const ContactManifold& found, const std::vector<Vector3d>& expected) {
  ASSERT_EQ(found.size, expected.size());
  for (const Vector3d& point : expected) {
    EXPECT_TRUE(std::any_of(
        found.points.begin(), found.points.begin() + found.size,
        [&](const ManifoldPoint& p) { return (p.point_on_a - point).norm() <= kExact; }))
        << point.transpose() << " is missing";
  }
}

void expectDistances(const ContactManifold& found, double distance) {
  for (std::size_t i = 0; i < found.size; ++i) {
    EXPECT_NEAR(found.points[i].distance, distance, kExact);
  }
}

const Box kTable{{2, 2, 0.5}};
const Box kCube{{0.5, 0.5, 0.5}};

TEST(Manifold, cubeOnTable_fourCorners) {
  const ContactManifold found = touch(kTable, at(0, 0, -0.5), kCube, at(0.3, 0.2, 0.49));
  EXPECT_EQ(found.feature, ContactFeature::face_face);
  expectNear(found.normal_a_to_b, {0, 0, 1}, "normal");
  expectPointsOnA(found, {{-0.2, -0.3, 0}, {0.8, -0.3, 0}, {0.8, 0.7, 0}, {-0.2, 0.7, 0}});
  expectDistances(found, -0.01);
  expectNear(found.center.point_on_a, {0.3, 0.2, 0}, "center");
}

TEST(Manifold, tableUnderCube_theSameFour) {
  const ContactManifold found = touch(kCube, at(0.3, 0.2, 0.49), kTable, at(0, 0, -0.5));
  EXPECT_EQ(found.feature, ContactFeature::face_face);
  expectNear(found.normal_a_to_b, {0, 0, -1}, "normal");
  expectDistances(found, -0.01);
  expectPointsOnA(found,
                  {{-0.2, -0.3, -0.01}, {0.8, -0.3, -0.01}, {0.8, 0.7, -0.01}, {-0.2, 0.7, -0.01}});
}

TEST(Manifold, cubeOverTheTablesEdge_fourCornersOfWhatTheyShare) {
  const ContactManifold found = touch(kTable, at(0, 0, -0.5), kCube, at(2, 0, 0.5));
  expectPointsOnA(found, {{1.5, -0.5, 0}, {2, -0.5, 0}, {2, 0.5, 0}, {1.5, 0.5, 0}});
  expectDistances(found, 0.0);
}

TEST(Manifold, cubeTurnedOnATallBox_fourOfEightCorners) {
  const Pose turned{eighthTurn(), {0, 0, 1.0}};
  const ContactManifold found = touch(kCube, at(0, 0, 0), kCube, turned);
  EXPECT_EQ(found.feature, ContactFeature::face_face);
  ASSERT_EQ(found.size, 4U);
  // Well spread: the four enclose most of the octagon, whose center they keep to.
  expectNear(found.center.point_on_a, {0, 0, 0.5}, "center");
}

TEST(Manifold, crossedBoxes_oneCrossingOfEdges) {
  // A's upper edge runs along x, B's lower one along y.
  const double s = std::sqrt(0.5);
  const Pose a{axes({1, 0, 0}, {0, s, s}), {0, 0, 0}};
  const Pose b{axes({s, 0, s}, {0, 1, 0}), {0.1, 0.2, 2.0 * std::sqrt(2.0) - 0.01}};
  const ContactManifold found = touch(Box{{3, 1, 1}}, a, Box{{1, 3, 1}}, b);
  EXPECT_EQ(found.feature, ContactFeature::edge_edge);
  expectNear(found.normal_a_to_b, {0, 0, 1}, "normal");
  expectPointsOnA(found, {{0.1, 0, std::sqrt(2.0)}});
  expectDistances(found, -0.01);
}

TEST(Manifold, cornerOnFace_onePoint) {
  const Pose standing{
      Eigen::Quaterniond::FromTwoVectors(Vector3d(1, 1, 1), Vector3d(0, 0, -1)).toRotationMatrix(),
      {0.3, 0.2, 0.5 * std::sqrt(3.0) - 0.001}};
  const ContactManifold found = touch(kTable, at(0, 0, -0.5), kCube, standing);
  EXPECT_EQ(found.feature, ContactFeature::vertex_face);
  expectPointsOnA(found, {{0.3, 0.2, 0}});
  expectDistances(found, -0.001);
}

TEST(Manifold, cubeOnItsEdge_twoPoints) {
  const double s = std::sqrt(0.5);
  const Pose on_edge{axes({1, 0, 0}, {0, s, s}), {0.3, 0.2, s - 0.001}};
  const ContactManifold found = touch(kTable, at(0, 0, -0.5), kCube, on_edge);
  EXPECT_EQ(found.feature, ContactFeature::edge_face);
  expectPointsOnA(found, {{-0.2, 0.2, 0}, {0.8, 0.2, 0}});
}

TEST(Manifold, cubeTiltedByALittle_keepsWhatIsWithinAMillimetre) {
  const auto tilted = [](double angle) {
    return Pose{Eigen::AngleAxisd(angle, Vector3d::UnitY()).toRotationMatrix(), {0, 0, 0.5}};
  };
  // Half a millimetre over the width of one metre: all four corners; one degree: two of them.
  EXPECT_EQ(touch(kTable, at(0, 0, -0.5), kCube, tilted(0.0005)).size, 4U);
  const ContactManifold found = touch(kTable, at(0, 0, -0.5), kCube, tilted(0.02));
  EXPECT_EQ(found.size, 2U);
  EXPECT_EQ(found.feature, ContactFeature::edge_face);
}

TEST(Manifold, parallelCapsules_twoEndsOfTheSharedStretch) {
  const Capsule capsule{1.0, 0.25};
  const ContactManifold found = touch(capsule, at(0, 0, 0), capsule, at(0.4, 0, 0.5));
  EXPECT_EQ(found.feature, ContactFeature::edge_edge);
  expectPointsOnA(found, {{0.25, 0, -0.5}, {0.25, 0, 1.0}});
  expectDistances(found, -0.1);
  expectNear(found.center.point_on_a, {0.25, 0, 0.25}, "center");
}

TEST(Manifold, nearlyParallelCapsules_centerDoesNotJump) {
  const Capsule capsule{1.0, 0.25};
  for (const double angle : {-1e-7, -1e-9, 1e-9, 1e-7}) {
    const Pose tilted{Eigen::AngleAxisd(angle, Vector3d::UnitY()).toRotationMatrix(),
                      {0.4, 0, 0.5}};
    const ContactManifold found = touch(capsule, at(0, 0, 0), capsule, tilted);
    EXPECT_EQ(found.size, 2U);
    EXPECT_LE((found.center.point_on_a - Vector3d(0.25, 0, 0.25)).norm(), 1e-6) << angle;
  }
}

TEST(Manifold, crossedCapsules_onePoint) {
  const ContactManifold found =
      touch(Capsule{1.0, 0.25}, at(0, 0, 0), Capsule{1.0, 0.25}, {zToY(), {0.4, 0.1, 0.2}});
  EXPECT_EQ(found.feature, ContactFeature::edge_edge);
  expectPointsOnA(found, {{0.25, 0, 0.2}});
}

TEST(Manifold, capsuleLyingOnBox_twoPoints) {
  const ContactManifold found =
      touch(Capsule{0.5, 0.1}, {zToX(), {1.8, 0, 0.09}}, kTable, at(0, 0, -0.5));
  EXPECT_EQ(found.feature, ContactFeature::edge_face);
  expectPointsOnA(found, {{1.3, 0, -0.01}, {2.0, 0, -0.01}});
  expectDistances(found, -0.01);
}

TEST(Manifold, standingCapsuleAndSphereOnBox_onePoint) {
  EXPECT_EQ(touch(Capsule{0.5, 0.1}, at(0, 0, 0.59), kTable, at(0, 0, -0.5)).feature,
            ContactFeature::vertex_face);
  const ContactManifold found = touch(Sphere{0.1}, at(0.5, 0, 0.09), kTable, at(0, 0, -0.5));
  EXPECT_EQ(found.feature, ContactFeature::vertex_face);
  expectPointsOnA(found, {{0.5, 0, -0.01}});
}

TEST(Manifold, cornersAndEdgesApart_areNamed) {
  EXPECT_EQ(touch(kCube, at(0, 0, 0), kCube, at(2, 2, 2)).feature, ContactFeature::vertex_vertex);
  const ContactManifold edges = touch(kCube, at(0, 0, 0), kCube, at(2, 2, 0.5));
  EXPECT_EQ(edges.feature, ContactFeature::edge_edge);
  EXPECT_EQ(edges.size, 2U);
  EXPECT_EQ(touch(Sphere{0.1}, at(2, 2, 0), kCube, at(0, 0, 0)).feature,
            ContactFeature::vertex_edge);
  EXPECT_STREQ(nameOf(ContactFeature::face_face), "face_face");
}

}  // namespace
}  // namespace collision_monitor::test
