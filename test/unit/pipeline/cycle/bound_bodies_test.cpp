// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/look_ahead/bound_bodies.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/place_bodies.h"
#include "support/expect_distance.h"
#include "support/robots/hand_made_setup.h"

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

constexpr double kReach = 0.2;  // [m]

/// A ball of 0.1 m on link 0, the root; one 0.3 m along x of link 1, which is at (1, 0, 0); and one
/// on link 2.
class BoundBodies : public testing::Test {
 protected:
  BoundBodies() {
    poses_.world_from_link[1].translation.x() = 1.0;
    bound();
  }
  void bound() {
    placeBodies(setup_, poses_, buffers_.body_poses);
    boundBodies(setup_, buffers_.body_poses, kReach, buffers_.bounds);
  }
  void grow(double duration) {
    bound();
    lookAhead(setup_, poses_, buffers_.body_poses, duration, buffers_.bounds);
    growBounds(buffers_.body_poses, buffers_.bounds);
  }
  /// Boxes are some ulps larger than they need to be.
  void expectBox(std::size_t body, const Vector3d& center, const Vector3d& half) const {
    const Aabb& box = buffers_.bounds.boxes[body];
    EXPECT_LE((box.min - (center - half)).norm(), 1e-12) << box.min.transpose();
    EXPECT_LE((box.max - (center + half)).norm(), 1e-12) << box.max.transpose();
  }
  Twist& twist(std::size_t link) {
    poses_.velocities.known[link] = 1;
    return poses_.velocities.of_link[link];
  }

  CycleSetup setup_ =
      handMadeSetup({{0, Sphere{0.1}}, {1, Sphere{0.1}, at(0.3, 0, 0)}, {2, Sphere{0.1}}});
  CycleBuffers buffers_ = makeBuffers(setup_, BroadPhaseKind::brute_force);
  LinkPoses poses_ = knownPoses(setup_);
};

TEST_F(BoundBodies, boxIsThatOfTheShapeAndHalfTheReach) {
  expectBox(0, Vector3d::Zero(), Vector3d::Constant(0.2));
  expectBox(1, {1.3, 0, 0}, Vector3d::Constant(0.2));
}

TEST_F(BoundBodies, bodyThatIsNotKnown_hasNoBox) {
  poses_.status[1] = LinkStatus::missing;
  bound();
  EXPECT_EQ(buffers_.bounds.known, (std::vector<unsigned char>{1, 0, 1}));
}

TEST_F(BoundBodies, sweptFar_boxHoldsStartAndEnd) {
  Pose start = poses_.world_from_link[1];
  start.translation.x() -= 2.0;
  buffers_.sweep.link_motions[1] = screwBetween(start, poses_.world_from_link[1]);
  buffers_.sweep.body_travel[1] = 2.0;
  sweepBounds(setup_, buffers_.body_poses, buffers_.sweep, kReach, buffers_.bounds);
  expectBox(1, {0.3, 0, 0}, {1.2, 0.2, 0.2});
  expectBox(0, Vector3d::Zero(), Vector3d::Constant(0.2));
}

TEST_F(BoundBodies, sweptByLittle_boxGrowsByTheWayOnAllSides) {
  buffers_.sweep.body_travel[1] = 0.02;
  sweepBounds(setup_, buffers_.body_poses, buffers_.sweep, kReach, buffers_.bounds);
  expectBox(1, {1.3, 0, 0}, Vector3d::Constant(0.22));
}

TEST_F(BoundBodies, grown_byAsFarAsSpeedAndTurnTakeTheBody) {
  twist(0) = {};
  // 2 rad/s: the center goes at 0.6 m/s, the surface 0.2 m/s faster.
  twist(1) = {Vector3d::Zero(), {0, 0, 2.0}};
  poses_.world_from_link[1] = Pose();
  grow(0.5);
  EXPECT_NEAR(buffers_.bounds.ahead[1], 0.4, 1e-12);
  expectBox(1, {0.3, 0, 0}, Vector3d::Constant(0.6));
  EXPECT_EQ(buffers_.bounds.ahead[0], 0.0);
}

TEST_F(BoundBodies, grown_whatAllShareCountsForNothing) {
  twist(0) = {{3, 0, 0}, {0, 0, 1}};
  twist(1) = {{3, 0, 0}, {0, 0, 1}};
  grow(0.5);
  EXPECT_NEAR(buffers_.bounds.ahead[1], 0.0, 1e-12);
  twist(1).linear.x() = 1.0;
  grow(0.5);
  EXPECT_NEAR(buffers_.bounds.ahead[1], 1.0, 1e-12) << "2 m/s against the root";
  poses_.part = {kWorldPart, 1, 1};
  grow(0.5);
  EXPECT_NEAR(buffers_.bounds.ahead[1], 0.5 * (std::hypot(1.0, 1.3) + 0.1), 1e-12)
      << "a part that floats shares nothing with the root";
}

TEST_F(BoundBodies, grown_velocityNotKnownOrNotFinite_boxStaysAndAheadIsNotKnown) {
  twist(0) = {};
  grow(0.5);
  EXPECT_TRUE(std::isnan(buffers_.bounds.ahead[1]));
  expectBox(1, {1.3, 0, 0}, Vector3d::Constant(0.2));
  twist(1).linear.x() = std::numeric_limits<double>::infinity();
  grow(0.5);
  EXPECT_TRUE(std::isnan(buffers_.bounds.ahead[1]));
  expectBox(1, {1.3, 0, 0}, Vector3d::Constant(0.2));
}

}  // namespace
}  // namespace collision_monitor::test
