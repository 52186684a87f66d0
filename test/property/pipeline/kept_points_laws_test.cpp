// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <utility>

#include "collision_monitor/geometry/ids.h"
#include "listening_scene.h"

// What is kept of pairs that nobody is told does not stand for what they say now.
namespace collision_monitor::test::measure_told_laws {
namespace {

LinkPoses restingPoses(const CycleSetup& setup) {
  LinkPoses poses = knownPoses(setup);
  poses.stamp_ns = kPeriod;
  for (std::size_t link = 0; link < poses.status.size(); ++link) {
    poses.velocities.known[link] = 1;
    poses.velocities.of_link[link] = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  }
  return poses;
}

/// A bar rocks above a floor, so that now one end is the nearest and closes, now the other. A box
/// is nearer and rests.
TEST(KeptPointsLaws, otherEndThatCloses_isTheSoonestAtOnce) {
  constexpr double kSpeed = 2.0;  // [rad/s]
  constexpr double kAngle = 0.05;
  const Eigen::Vector3d center(0.0, 0.0, 0.12);
  CycleSetup setup = geometrySetup(
      {boxMesh({0.3, 0.3, 0.01}), joined(boxMesh({0.14, 0.01, 0.01}), boxMesh({0.02, 0.02, 0.012})),
       boxMesh({0.02, 0.02, 0.02})},
      {});
  setup.refine.budget = kAmple;
  setup.limits.warning_distance = 0.3;
  setup.limits.report_distance = 0.4;
  setup.ahead.horizon = 1.0;  // [s]
  Watches watches(setup);
  LinkPoses poses = restingPoses(setup);
  poses.world_from_link[1].translation = center;
  poses.world_from_link[2].translation = {0.25, 0.25, 0.07};
  int soon = 0;
  for (int cycle = 0; cycle < 400; ++cycle) {
    poses.stamp_ns += kPeriod;
    const double phase = 1e-3 * cycle * kSpeed / kAngle;
    const Eigen::Vector3d turning(0.0, kSpeed * std::cos(phase), 0.0);
    poses.world_from_link[1].rotation =
        Eigen::AngleAxisd(kAngle * std::sin(phase), Eigen::Vector3d::UnitY()).toRotationMatrix();
    poses.velocities.of_link[1] = {-turning.cross(center), turning};
    watches.run(setup, poses);
    const double told = watches.told.events.time_to_contact;
    if (std::isinf(told)) {
      ASSERT_TRUE(std::isinf(watches.untold.events.time_to_contact)) << cycle;
    } else {
      ASSERT_NEAR(told, watches.untold.events.time_to_contact, 0.02 * told) << cycle;
      ++soon;
    }
  }
  EXPECT_GT(soon, 100);
}

/// The bar rocks within the stop distance while a contact of two others holds the scale at 0. Then
/// it rests and the contact parts: the bar is stopped if the end that is nearer had closed.
TEST(KeptPointsLaws, barThatRests_isStoppedIfItsNearerEndClosed) {
  constexpr double kSpeed = 2.0;  // [rad/s]
  constexpr double kAngle = 0.05;
  constexpr int kRound = 40;  // cycles, of which the last is at rest
  const Box box{{0.05, 0.05, 0.05}};
  CycleSetup setup = geometrySetup(
      {boxMesh({0.3, 0.3, 0.01}), joined(boxMesh({0.14, 0.01, 0.01}), boxMesh({0.02, 0.02, 0.012})),
       boxMesh({0.02, 0.02, 0.02}), box, box},
      {});
  setup.refine.budget = kAmple;
  setup.limits.warning_distance = 0.3;
  setup.limits.report_distance = 0.4;
  setup.ahead.stop.stop_distance = 0.2;
  setup.ahead.stop.release_time = 1e-9;  // no scale depends on earlier ones
  Watches watches(setup);
  LinkPoses poses = restingPoses(setup);
  poses.world_from_link[1].translation = {0.0, 0.0, 0.12};
  poses.world_from_link[2].translation = {0.25, 0.25, 0.07};
  poses.world_from_link[3].translation = {0.0, 5.0, 0.0};
  poses.world_from_link[4].translation = {0.09, 5.0, 0.0};
  double phase = 0.0;
  int stopped = 0;
  int freed = 0;
  for (int cycle = 1; cycle <= 100 * kRound; ++cycle) {
    poses.stamp_ns += kPeriod;
    const bool rests = cycle % kRound == 0;
    phase += rests ? 0.0 : 1e-3 * kSpeed / kAngle;
    const Eigen::Vector3d turning(0.0, rests ? 0.0 : kSpeed * std::cos(phase), 0.0);
    poses.world_from_link[1].rotation =
        Eigen::AngleAxisd(kAngle * std::sin(phase), Eigen::Vector3d::UnitY()).toRotationMatrix();
    poses.velocities.of_link[1] = {-turning.cross(poses.world_from_link[1].translation), turning};
    poses.velocities.of_link[4].linear.x() = rests ? 0.1 : -0.1;  // it need not move
    watches.run(setup, poses);
    const double told = watches.told.memory.speed.scale;
    ASSERT_EQ(watches.untold.memory.speed.scale, told) << cycle;
    stopped += rests && told == 0.0 ? 1 : 0;
    freed += rests && told == 1.0 ? 1 : 0;
  }
  EXPECT_GT(stopped, 20) << "the nearer end had closed";
  EXPECT_GT(freed, 20) << "the nearer end had parted";
}

/// The pose of an angle that has one corner at `corner`, its least in x.
Pose poseWithCornerAt(const Eigen::Vector3d& corner) {
  Pose pose;
  pose.rotation = (Eigen::AngleAxisd(-0.25 * M_PI, Eigen::Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()))
                      .toRotationMatrix();
  Eigen::Vector3d least(1.0, 0.0, 0.0);
  for (const Eigen::Vector3d& vertex : angleMesh().vertices) {
    const Eigen::Vector3d turned = pose.rotation * vertex;
    least = turned.x() < least.x() ? turned : least;
  }
  pose.translation = corner - least;
  return pose;
}

/// A corner is 10 um deep in an angle and leaves it slowly, while others are deeper in each other.
TEST(KeptPointsLaws, shallowOverlapThatEnds_endsWithAToleranceToo) {
  constexpr double kDepth = 1e-5;  // [m]
  constexpr double kStep = 1e-6;   // [m] a cycle
  CycleSetup setup =
      geometrySetup({angleMesh(), angleMesh(), bumpyMesh(0.1, 12), bumpyMesh(0.1, 12)}, {});
  setup.refine.budget = kAmple;
  setup.limits.hysteresis = 0.0;
  Watches watches(setup, 1e-4);
  LinkPoses poses = restingPoses(setup);
  poses.world_from_link[2].translation = {3.0, 0.0, 0.0};
  poses.world_from_link[3].translation = {3.03, 0.01, 0.0};
  poses.velocities.of_link[1].linear = {1e9 * kStep / static_cast<double>(kPeriod), 0.0, 0.0};
  int in_contact = 0;
  for (int cycle = 0; cycle < 100; ++cycle) {
    poses.stamp_ns += kPeriod;
    poses.world_from_link[1] = poseWithCornerAt({0.3 - kDepth + kStep * cycle, 0.05, 0.0});
    watches.run(setup, poses);
    ASSERT_EQ(watches.told.events.verdicts, watches.untold.events.verdicts) << cycle;
    in_contact += watches.told.events.verdicts[0] == Verdict::contact ? 1 : 0;
  }
  EXPECT_GT(in_contact, 5);
  EXPECT_LT(in_contact, 20);
}

/// Two overlaps were stopped. The deeper one parts, the other rests, and its depth is kept.
TEST(KeptPointsLaws, shallowOverlapThatRests_staysStopped) {
  const TriangleMesh mesh = bumpyMesh(0.1, 16);
  CycleSetup setup = geometrySetup({mesh, mesh, mesh, mesh}, {});
  setup.refine.budget = kAmple;
  setup.ahead.stop.release_time = 1e-9;  // no scale depends on earlier ones
  setup.ahead.stop.creep_scale = 0.1;
  Watches watches(setup);
  LinkPoses poses = randomLinkPoses(setup, 0.0, 1);
  const double apart[] = {0.0, 0.085, 0.0, 0.09};  // [m] along x; the second two are 1 m beside
  for (std::size_t link = 0; link < 4; ++link) {
    poses.world_from_link[link] = {Eigen::Matrix3d::Identity(),
                                   {apart[link], link < 2 ? 0.0 : 1.0, 0.0}};
    poses.velocities.known[link] = 1;
  }
  const auto move = [&](double of_deep, double of_shallow, int cycles) {  // [m/s] away
    constexpr double kSeconds = 1e-9 * static_cast<double>(kPeriod);
    for (int cycle = 0; cycle < cycles; ++cycle) {
      poses.stamp_ns += kPeriod;
      for (const auto& [link, speed] : {std::pair(1U, of_deep), std::pair(3U, of_shallow)}) {
        poses.velocities.of_link[link].linear = {speed, 0.0, 0.0};
        poses.world_from_link[link].translation.x() += kSeconds * speed;
      }
      watches.run(setup, poses);
    }
  };
  move(-0.05, -0.05, 20);
  EXPECT_EQ(watches.untold.memory.speed.scale, 0.0) << "both get deeper";
  move(-0.05, 0.0, 3);
  move(0.05, 0.0, 1);
  EXPECT_EQ(watches.told.memory.speed.scale, 0.1) << "the deeper one parts";
  EXPECT_EQ(watches.untold.memory.speed.scale, 0.1) << "the deeper one parts";
}

}  // namespace
}  // namespace collision_monitor::test::measure_told_laws
