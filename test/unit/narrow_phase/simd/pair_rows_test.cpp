// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/narrow_phase/pair_rows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "support/expect_distance.h"
#include "support/instruction_sets.h"

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

/// Rows of unit boxes or other shapes at the origin against B, B alone in rows 1, 2, 3 ...
SignedDistance measureOne(const Shape& a, const Pose& world_from_a, const Shape& b,
                          const Pose& world_from_b) {
  const auto rows = std::make_unique<PairRows>();
  const Core core_a = coreOf(a);
  const Core core_b = coreOf(b);
  // Neighbours in the same vector must not matter: row 0 holds another pair.
  writeRow(core_a, at(7, 8, 9), 0, rows->a);
  writeRow(core_b, at(-1, 2, 30), 0, rows->b);
  writeRow(core_a, world_from_a, 1, rows->a);
  writeRow(core_b, world_from_b, 1, rows->b);
  measureRows(core_a.kind, core_b.kind, 2, *rows);
  SignedDistance measured;
  readAnswer(*rows, 1, false, measured);
  return measured;
}

/// A rotation that turns a diagonal of a unit cube upright.
Eigen::Matrix3d onItsCorner() {
  const Vector3d x = Vector3d(2, 1, 1).normalized();
  const Vector3d y = Vector3d(-1, 5, -3).normalized();
  return axes(x, y);
}

/// Every answer below is asked of every instruction set.
class PairRowsTest : public testing::TestWithParam<std::int64_t> {
  OnlyInstructionSet only_{GetParam()};
};

TEST_P(PairRowsTest, spheres) {
  const auto found = measureOne(Sphere{0.5}, at(1, 0, 0), Sphere{1.0}, at(1, 3, 4));
  expectDistance(found, 3.5, {0, 0.6, 0.8}, {1, 0.3, 0.4});
}

TEST_P(PairRowsTest, concentricSpheres_areLeftToThePlainTwin) {
  const auto found = measureOne(Sphere{0.5}, Pose{}, Sphere{1.0}, Pose{});
  EXPECT_NEAR(found.distance, -1.5, kExact);
  expectConsistent(found);
}

TEST_P(PairRowsTest, sphereBesideACapsule) {
  const auto found = measureOne(Sphere{0.5}, at(3, 0, 0.25), Capsule{1.0, 0.5}, Pose{});
  expectDistance(found, 2.0, {-1, 0, 0}, {2.5, 0, 0.25});
}

TEST_P(PairRowsTest, sphereBeyondACapsulesEnd) {
  const auto found = measureOne(Sphere{0.5}, at(0, 3, 5), Capsule{1.0, 0.5}, Pose{});
  expectDistance(found, 4.0, {0, -0.6, -0.8}, {0, 2.7, 4.6});
}

TEST_P(PairRowsTest, crossedCapsules) {
  const auto found =
      measureOne(Capsule{1.0, 0.25}, Pose{}, Capsule{2.0, 0.5}, Pose{zToX(), {0.5, 2, 0.5}});
  expectDistance(found, 1.25, {0, 1, 0}, {0, 0.25, 0.5});
}

TEST_P(PairRowsTest, parallelCapsules_pointsInTheMiddleOfWhatTheyShare) {
  const auto found = measureOne(Capsule{1.0, 0.25}, Pose{}, Capsule{2.0, 0.5}, at(3, 0, 2));
  expectDistance(found, 2.25, {1, 0, 0}, {0.25, 0, 0.5});
}

TEST_P(PairRowsTest, longCapsulesThatCross_atEveryAngle) {
  // Both axes lie along the faces of a slab as thick as the gap and cross off their middles.
  const Eigen::Matrix3d tilted = onItsCorner();
  for (const double sine : {1.0, 0.5, 0.11, 0.1, 0.0999, 0.01, 1e-4, 1e-9}) {
    for (const double gap : {1.0, 2e-3, 1e-6}) {
      const Vector3d u = tilted.col(0);
      const Vector3d v = std::sqrt(1.0 - sine * sine) * tilted.col(0) + sine * tilted.col(1);
      const Pose a{axes(tilted.col(1), tilted.col(2)), -7.0 * u};
      const Pose b{axes(v.cross(tilted.col(2)), -tilted.col(2)), gap * tilted.col(2) + 8.0 * v};
      const auto found = measureOne(Capsule{10.0, 0.25}, a, Capsule{10.0, 0.5}, b);
      EXPECT_NEAR(found.distance, gap - 0.75, kExact) << "sine " << sine;
      EXPECT_NEAR(found.normal_a_to_b.norm(), 1.0, kExact);
      if (sine >= 0.01) {
        expectNear(found.normal_a_to_b, tilted.col(2), "normal");
      }
    }
  }
}

TEST_P(PairRowsTest, capsulesWhoseSegmentsCross) {
  const auto found =
      measureOne(Capsule{1.0, 0.25}, Pose{}, Capsule{2.0, 0.5}, Pose{zToX(), {0.5, 0, 0.5}});
  EXPECT_NEAR(found.distance, -0.75, kExact);
  EXPECT_NEAR(std::abs(found.normal_a_to_b.y()), 1.0, kExact);
  expectConsistent(found);
}

TEST_P(PairRowsTest, sphereOffACorner) {
  const auto found = measureOne(Sphere{1.0}, at(-3, -4, -4), Box{{1, 2, 3}}, Pose{});
  expectDistance(found, 2.0, {2.0 / 3, 2.0 / 3, 1.0 / 3}, {-7.0 / 3, -10.0 / 3, -11.0 / 3});
}

TEST_P(PairRowsTest, sphereInABox_leavesByTheNearestFace) {
  const auto found = measureOne(Sphere{0.5}, at(0.5, -1.75, 0), Box{{1, 2, 3}}, Pose{});
  expectDistance(found, -0.75, {0, 1, 0}, {0.5, -1.25, 0});
}

TEST_P(PairRowsTest, capsuleAcrossABoxsEdge) {
  // The segment runs along y; x and z are 3 and 4 beyond the edge.
  const auto found =
      measureOne(Capsule{0.5, 1.0}, Pose{zToY(), {4, 0.25, 5}}, RoundedBox{{1, 1, 1}, 0.5}, Pose{});
  expectDistance(found, 3.5, {-0.6, 0, -0.8}, {3.4, 0.25, 4.2});
}

TEST_P(PairRowsTest, capsuleThroughABox_leavesByItsEnd) {
  // Tilted in every direction; its lower end is 0.5 below the top of the box.
  const Vector3d z(0.36, 0.48, 0.8);
  const Vector3d x(-0.8, 0.6, 0.0);
  const auto found = measureOne(Capsule{5.0, 0.25}, Pose{axes(x, z.cross(x)), {1.8, 2.4, 6.5}},
                                Box{{8, 8, 3}}, Pose{});
  EXPECT_NEAR(found.distance, -0.75, kExact);
  expectNear(found.normal_a_to_b, {0, 0, -1}, "normal");
  expectNear(found.point_on_a, {0, 0, 2.25}, "point on a");
  expectConsistent(found);
}

TEST_P(PairRowsTest, cornerOverAFace) {
  const Eigen::Matrix3d tilted = onItsCorner();
  // Of |R| (1, 1, 1) the third component: how far the cube reaches down.
  const double reach = tilted.row(2).cwiseAbs().sum();
  const Pose above{tilted, {0, 0, 4.0 + reach}};
  const auto found = measureOne(Box{{3, 3, 1}}, Pose{}, Box{{1, 1, 1}}, above);
  EXPECT_NEAR(found.distance, 3.0, kExact);
  expectNear(found.normal_a_to_b, {0, 0, 1}, "normal");
  const auto sunk =
      measureOne(Box{{3, 3, 1}}, Pose{}, Box{{1, 1, 1}}, Pose{tilted, {0, 0, 0.75 + reach}});
  EXPECT_NEAR(sunk.distance, -0.25, kExact);
  expectConsistent(sunk);
}

TEST_P(PairRowsTest, cornerAgainstCorner) {
  // Both far along (1, 1, 1), so that the corners (1, 1, 1) and the one opposite are nearest.
  const Eigen::Matrix3d tilted = onItsCorner();
  const Vector3d corner =
      tilted * Vector3d(tilted.transpose() * Vector3d::Ones()).unaryExpr([](double x) {
        return x < 0.0 ? 1.0 : -1.0;
      });
  const Pose away{tilted, Vector3d::Constant(3.0) - corner};
  const auto found = measureOne(Box{{1, 1, 1}}, Pose{}, Box{{1, 1, 1}}, away);
  expectDistance(found, std::sqrt(12.0), Vector3d::Ones().normalized(), Vector3d::Ones());
}

TEST_P(PairRowsTest, boxesWithTheSameAxes_cornerAgainstCorner) {
  const auto found = measureOne(Box{{1, 1, 1}}, Pose{}, Box{{1, 1, 1}}, at(4, 5, 3.5));
  const Vector3d between(2, 3, 1.5);
  expectDistance(found, between.norm(), between.normalized(), Vector3d::Ones());
}

TEST_P(PairRowsTest, parallelEdges_pointsInTheMiddleOfWhatTheyShare) {
  const auto found = measureOne(Box{{1, 1, 1}}, Pose{}, Box{{1, 1, 1}}, at(4, 5, 0.5));
  const Vector3d between(2, 3, 0);
  expectDistance(found, between.norm(), between.normalized(), {1, 1, 0.25});
}

TEST_P(PairRowsTest, cubeOnTable_isLeftToThePlainTwin) {
  const auto found = measureOne(Box{{3, 3, 1}}, Pose{}, Box{{1, 1, 1}}, at(0.5, 0, 2.5));
  expectDistance(found, 0.5, {0, 0, 1}, {0.5, 0, 1});
}

TEST_P(PairRowsTest, poseThatIsNotFinite_givesNoDistance) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Shape shapes[] = {Sphere{0.5}, Capsule{0.5, 0.5}, Box{{1, 2, 3}}};
  Pose turned;
  turned.rotation(1, 2) = nan;
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = a; b < 3; ++b) {
      EXPECT_TRUE(std::isnan(measureOne(shapes[a], at(0, nan, 0), shapes[b], Pose{}).distance));
      EXPECT_TRUE(std::isnan(measureOne(shapes[a], Pose{}, shapes[b], at(0, 0, nan)).distance));
      if (a > 0) {
        EXPECT_TRUE(std::isnan(measureOne(shapes[a], turned, shapes[b], at(1, 2, 3)).distance));
      }
      if (b > 0) {
        EXPECT_TRUE(std::isnan(measureOne(shapes[a], Pose{}, shapes[b], turned).distance));
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(EveryInstructionSet, PairRowsTest, testing::ValuesIn(instructionSets()),
                         [](const auto& target) { return hwy::TargetName(target.param); });

}  // namespace
}  // namespace collision_monitor::test
