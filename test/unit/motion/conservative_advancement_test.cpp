// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "motion/conservative_advancement.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "geometry/constants.h"
#include "support/expect_distance.h"
#include "support/random_poses.h"
#include "support/sample_meshes.h"

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

constexpr double kTime = 1e-6;

ScrewMotion still(const Pose& pose) { return screwBetween(pose, pose); }

ScrewMotion straight(const Pose& start, const Vector3d& travel) {
  Pose end = start;
  end.translation += travel;
  return screwBetween(start, end);
}

Pose turnedAboutZ(double angle, const Vector3d& origin) {
  return {Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix(), origin};
}

SweptContact meet(const ConvexGeometry& a, const ScrewMotion& motion_a, const ConvexGeometry& b,
                  const ScrewMotion& motion_b, const SweepLimits& limits = SweepLimits()) {
  static const auto workspace = std::make_unique<ConvexWorkspace>();
  ConvexWarmStart warm;
  ConvexSearch search{*workspace, warm};
  return firstContact(MovingConvex{a, ballOf(a), motion_a}, MovingConvex{b, ballOf(b), motion_b},
                      limits, search);
}

SweptContact meet(const TriangleMesh& a, const ScrewMotion& motion_a, const TriangleMesh& b,
                  const ScrewMotion& motion_b, const SweepLimits& limits = SweepLimits()) {
  static const auto memory = std::make_unique<MeshQueryMemory>();
  const MeshTree tree_a(a, true);
  const MeshTree tree_b(b, true);
  return firstContact(MovingMesh{tree_a, motion_a}, MovingMesh{tree_b, motion_b}, limits, *memory);
}

/// A rod of half length 2 m and radius 0.1 m that lies along x and turns by a quarter about z.
ScrewMotion turningRod() {
  const Pose along_x{zToX(), Vector3d::Zero()};
  return screwBetween(along_x, turnedAboutZ(0.5 * kPi, Vector3d::Zero()) * along_x);
}

TEST(ConservativeAdvancement, rodTurnsIntoABall_touchesWhereTheSineSays) {
  // A ball of radius 0.1 m at (0, 1): the rod's axis is sin(90 deg - angle) * 1 m from it... that
  // is the cosine, which is 0.2 when they touch.
  const double expected = std::acos(0.2) / (0.5 * kPi);
  const SweptContact found = meet(Capsule{2.0, 0.1}, turningRod(), Sphere{0.1}, still(at(0, 1, 0)));
  ASSERT_EQ(found.state, SweepState::contact);
  EXPECT_NEAR(found.time, expected, kTime);
  EXPECT_NEAR(found.measured.distance, 0.0, 1.1e-7);
  expectNear((found.measured.point_on_b - Vector3d(0, 1, 0)).normalized(),
             -found.measured.normal_a_to_b, "towards the rod");
}

TEST(ConservativeAdvancement, rodTurnsPastABall_clear) {
  const SweptContact found =
      meet(Capsule{2.0, 0.1}, turningRod(), Sphere{0.1}, still(at(-0.15, 2.2, 0)));
  EXPECT_EQ(found.state, SweepState::clear);
  EXPECT_EQ(found.time, 1.0);
}

TEST(ConservativeAdvancement, withinADistance_isThatMuchEarlier) {
  SweepLimits limits;
  limits.contact_distance = 0.25;
  const auto found = meet(Cylinder{0.5, 1.0}, still(at(0, 0, 0)), Sphere{0.5},
                          straight(at(5, 0, 0), {-7, 0, 0}), limits);
  ASSERT_EQ(found.state, SweepState::contact);
  EXPECT_NEAR(found.time, 3.25 / 7.0, kTime);
  EXPECT_NEAR(found.measured.distance, 0.25, 1.1e-7);
}

TEST(ConservativeAdvancement, withinADepth_isThatMuchLater) {
  SweepLimits limits;
  limits.contact_distance = -0.1;
  const auto found = meet(Box{{1, 1, 1}}, still(at(0, 0, 0)), Box{{1, 1, 1}},
                          straight(at(4, 0, 0), {-4, 0, 0}), limits);
  ASSERT_EQ(found.state, SweepState::contact);
  EXPECT_NEAR(found.time, 2.1 / 4.0, kTime);
}

TEST(ConservativeAdvancement, straightBoxes_areSettledByTheClosedForm) {
  const auto found =
      meet(Box{{1, 1, 1}}, still(at(0, 0, 0)), Box{{1, 1, 1}}, straight(at(3, 0, 0), {-4, 0.5, 0}));
  ASSERT_EQ(found.state, SweepState::contact);
  EXPECT_NEAR(found.time, 0.25, kExact);
  EXPECT_EQ(found.work, 1U);
  const auto past =
      meet(Box{{1, 1, 1}}, still(at(0, 0, 0)), Box{{1, 1, 1}}, straight(at(3, 3, 0), {-4, 0.5, 0}));
  EXPECT_EQ(past.state, SweepState::clear);
  EXPECT_EQ(past.work, 0U);
}

TEST(ConservativeAdvancement, boxTipsOntoAPlane) {
  // A cube of 2 m, 0.2 m over the plane, tips by a quarter about its lower edge along y at x = 0:
  // its other lower edge, 2 m behind, goes down by 2 m times the sine.
  const Pose start = at(-1, 0, 1.2);
  const Pose edge = at(0, 0, 0.2);
  const Pose quarter{Eigen::AngleAxisd(-0.5 * kPi, Vector3d::UnitY()).toRotationMatrix(),
                     Vector3d::Zero()};
  const ScrewMotion motion = screwBetween(start, edge * quarter * inverse(edge) * start);
  const auto found = meet(Box{{1, 1, 1}}, motion, HalfSpace{}, still(Pose()));
  ASSERT_EQ(found.state, SweepState::contact);
  EXPECT_NEAR(found.time, std::asin(0.1) / (0.5 * kPi), kTime);
  expectNear(found.measured.normal_a_to_b, -Vector3d::UnitZ(), "normal");
}

TEST(ConservativeAdvancement, thinPlateAtSpeed_isCaughtWhileItTurns) {
  // 1 mm thick, 100 m in the interval, turning by a radian on its way.
  const ScrewMotion plate = screwBetween(
      at(0, 0, 50),
      {Eigen::AngleAxisd(1.0, Vector3d::UnitZ()).toRotationMatrix(), Vector3d(0, 0, -50)});
  const Box shape{{0.3, 0.3, 0.0005}};
  const auto found = meet(shape, plate, shape, still(Pose()));
  ASSERT_EQ(found.state, SweepState::contact);
  EXPECT_NEAR(found.time, (50.0 - 0.001) / 100.0, kTime);
}

TEST(ConservativeAdvancement, bothMoveAlike_neverMeetAndTakeOneStep) {
  const Pose a = at(0, 0, 0);
  const Pose b = at(0.21, 0, 0);
  const Pose motion = turnedAboutZ(2.0, {5, 0, 1});
  const auto found = meet(Capsule{0.1, 0.1}, screwBetween(a, motion * a), Box{{0.1, 0.1, 0.1}},
                          screwBetween(b, motion * b));
  EXPECT_EQ(found.state, SweepState::clear);
  EXPECT_LE(found.work, 2U);
}

TEST(ConservativeAdvancement, touchingAtTheStart_atZero) {
  const auto found = meet(Sphere{1}, still(at(0, 0, 0)), Capsule{1, 1}, still(at(2, 0, 0)));
  EXPECT_EQ(found.state, SweepState::contact);
  EXPECT_EQ(found.time, 0.0);
}

TEST(ConservativeAdvancement, budgetSpent_undecidedAndClearUntilThen) {
  SweepLimits limits;
  limits.budget = 2;
  const auto found = meet(Capsule{2.0, 0.1}, turningRod(), Sphere{0.1}, still(at(0, 1, 0)), limits);
  EXPECT_EQ(found.state, SweepState::undecided);
  EXPECT_EQ(found.work, 2U);
  EXPECT_GT(found.time, 0.1);
  EXPECT_LE(found.time, std::acos(0.2) / (0.5 * kPi));
}

TEST(ConservativeAdvancement, poseThatIsNotFinite_unknown) {
  ScrewMotion broken;
  broken.travel.y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(meet(Sphere{1}, broken, Sphere{1}, still(at(9, 0, 0))).state, SweepState::unknown);
  EXPECT_EQ(meet(sphereMesh(1.0, 6), broken, sphereMesh(1.0, 6), still(at(9, 0, 0))).state,
            SweepState::unknown);
  EXPECT_EQ(meet(HalfSpace{}, still(Pose()), HalfSpace{}, still(Pose())).state,
            SweepState::unknown);
}

TEST(ConservativeAdvancement, shapesAnswerAsConvexGeometries) {
  const Shape rod = Capsule{2.0, 0.1};
  const Shape ball = Sphere{0.1};
  const ScrewMotion turning = turningRod();
  const ScrewMotion standing = still(at(0, 1, 0));
  const auto found = firstContact({rod, turning}, {ball, standing}, SweepLimits());
  ASSERT_EQ(found.state, SweepState::contact);
  EXPECT_NEAR(found.time, std::acos(0.2) / (0.5 * kPi), kTime);
}

TEST(ConservativeAdvancement, meshesHeadOn_gapOverTravel) {
  const TriangleMesh box = boxMesh({0.5, 0.5, 0.5});
  const auto found = meet(box, still(at(0, 0, 0)), box, straight(at(0.2, 0.3, 5), {0, 0, -20}));
  ASSERT_EQ(found.state, SweepState::contact);
  EXPECT_NEAR(found.time, 0.2, kTime);
  EXPECT_NEAR(found.measured.point_on_a.z(), 0.5, 1e-6);
  expectNear(found.measured.normal_a_to_b, Vector3d::UnitZ(), "normal");
}

TEST(ConservativeAdvancement, meshesSwapped_giveTheSameTimeAndTheOtherNormal) {
  const TriangleMesh small = boxMesh({0.1, 0.1, 0.1});
  const TriangleMesh large = boxMesh({1.0, 1.0, 0.1});
  const auto found = meet(small, straight(at(0, 0, 2), {0, 0, -5}), large, still(Pose()));
  ASSERT_EQ(found.state, SweepState::contact);
  EXPECT_NEAR(found.time, 1.8 / 5.0, kTime);
  expectNear(found.measured.normal_a_to_b, -Vector3d::UnitZ(), "normal");
}

TEST(ConservativeAdvancement, meshLooksOnlyWhereItMayMeet) {
  // Two spheres of some thousand triangles, 1 cm apart, one of which moves by 2 cm.
  const TriangleMesh sphere = sphereMesh(0.5, 48);
  const auto found = meet(sphere, still(Pose()), sphere, straight(at(1.01, 0, 0), {-0.02, 0, 0}));
  EXPECT_EQ(found.state, SweepState::contact);
  EXPECT_LT(found.work, sphere.triangles.size());
  const auto away = meet(sphere, still(Pose()), sphere, straight(at(2, 0, 0), {-0.02, 0, 0}));
  EXPECT_EQ(away.state, SweepState::clear);
  EXPECT_LE(away.work, 1U);
}

/// A square of 1 m, across z, of many triangles.
TriangleMesh plate(std::uint32_t squares) {
  TriangleMesh mesh;
  for (std::uint32_t y = 0; y <= squares; ++y) {
    for (std::uint32_t x = 0; x <= squares; ++x) {
      mesh.vertices.emplace_back(static_cast<double>(x) / squares, static_cast<double>(y) / squares,
                                 0.0);
    }
  }
  for (std::uint32_t y = 0; y < squares; ++y) {
    for (std::uint32_t x = 0; x < squares; ++x) {
      const std::uint32_t first = y * (squares + 1) + x;
      const std::uint32_t above = first + squares + 1;
      mesh.triangles.push_back({first, first + 1, above});
      mesh.triangles.push_back({first + 1, above + 1, above});
    }
  }
  return mesh;
}

TEST(ConservativeAdvancement, platesThatSlide_measureFewTriangles) {
  const TriangleMesh mesh = plate(10);
  SweepLimits limits;
  limits.budget = 100'000;
  const auto found =
      meet(mesh, still(Pose()), mesh, straight(at(0, 0, 1e-3), {0.02, 0.01, 0}), limits);
  EXPECT_EQ(found.state, SweepState::clear);
  EXPECT_LT(found.work, 6000U);
}

TEST(ConservativeAdvancement, boxThatSlidesOnAPlate_takesFewSteps) {
  static const auto memory = std::make_unique<MeshQueryMemory>();
  const MeshTree tree(plate(10));
  const Shape box = Box{{0.1, 0.1, 0.1}};
  SweepLimits limits;
  limits.budget = 1'000'000;
  const auto found = firstContact(MovingMesh{tree, still(Pose())},
                                  MovingShape{box, straight(at(0.4, 0.5, 0.1001), {0.2, 0.1, 0})},
                                  limits, *memory);
  EXPECT_EQ(found.state, SweepState::clear);
  EXPECT_LT(found.work, 1000U);
}

TEST(ConservativeAdvancement, turningMeshAndShape_asTwoMeshes) {
  static const auto memory = std::make_unique<MeshQueryMemory>();
  Random random(20260101);
  const MeshTree tree(plate(4));
  const MeshTree box_tree(boxMesh({0.1, 0.2, 0.3}));
  const Shape box = Box{{0.1, 0.2, 0.3}};
  SweepLimits limits;
  limits.budget = 1'000'000;
  int contacts = 0;
  for (int i = 0; i < 300; ++i) {
    const ScrewMotion of_plate = screwBetween(randomPose(random, 0.5), randomPose(random, 0.5));
    const ScrewMotion of_box = screwBetween(randomPose(random, 1.0), randomPose(random, 1.0));
    const auto with_shape =
        firstContact(MovingMesh{tree, of_plate}, MovingShape{box, of_box}, limits, *memory);
    const auto with_mesh =
        firstContact(MovingMesh{tree, of_plate}, MovingMesh{box_tree, of_box}, limits, *memory);
    ASSERT_NE(with_shape.state, SweepState::undecided);
    if (with_shape.time > 0.0 && with_mesh.time > 0.0) {
      EXPECT_EQ(with_shape.state, with_mesh.state);
      EXPECT_NEAR(with_shape.time, with_mesh.time, 1e-4);
      contacts += with_shape.state == SweepState::contact ? 1 : 0;
    }
  }
  EXPECT_GT(contacts, 50);
}

TEST(ConservativeAdvancement, meshAndBall) {
  static const auto memory = std::make_unique<MeshQueryMemory>();
  const MeshTree box(boxMesh({0.5, 0.5, 0.5}), true);
  const Shape ball = Sphere{0.25};
  const ScrewMotion standing = still(Pose());
  const ScrewMotion falling = straight(at(0.1, 0.2, 2.75), {0, 0, -8});
  const auto found =
      firstContact(MovingMesh{box, standing}, MovingShape{ball, falling}, SweepLimits(), *memory);
  ASSERT_EQ(found.state, SweepState::contact);
  EXPECT_NEAR(found.time, 0.25, kTime);
  const ScrewMotion aside = straight(at(0.76, 0.2, 2.75), {0, 0, -8});
  EXPECT_EQ(
      firstContact(MovingMesh{box, standing}, MovingShape{ball, aside}, SweepLimits(), *memory)
          .state,
      SweepState::clear);
}

}  // namespace
}  // namespace collision_monitor::test
