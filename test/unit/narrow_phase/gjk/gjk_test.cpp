// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/gjk/gjk.h"

#include <gtest/gtest.h>

#include "geometry/constants.h"
#include "support/expect_distance.h"

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;
using GjkState = GjkResult::State;

ConvexCore boxCore(double x, double y, double z) { return {ConvexCore::Kind::box, {x, y, z}}; }

/// A stands at the origin.
ConvexPair pairFrom(const ConvexCore& a, const ConvexCore& b, double x, double y, double z) {
  return makeConvexPair(a, Pose(), b, at(x, y, z));
}

GjkResult runCold(ConvexPair pair, double cutoff = kInfinity) {
  return runGjk(pair, ConvexWarmStart(), {cutoff});
}

void expectSettled(const GjkResult& found, double distance, const Vector3d& normal) {
  EXPECT_EQ(found.state, GjkState::settled);
  EXPECT_NEAR(found.simplex.distance, distance, kExact);
  EXPECT_NEAR(found.lower, distance, kExact);
  expectNear(found.simplex.normal, normal, "normal");
}

TEST(Gjk, segmentsThatCross_touch) {
  const GjkResult found = runCold(pairFrom(boxCore(1, 0, 0), boxCore(0, 1, 0), 0.25, 0.5, 0));
  EXPECT_EQ(found.state, GjkState::overlapping);
}

TEST(Gjk, segmentsPastEachOther_settleAtTheGap) {
  const GjkResult found = runCold(pairFrom(boxCore(1, 0, 0), boxCore(0, 1, 0), 0.25, 0.5, 0.75));
  expectSettled(found, 0.75, Vector3d::UnitZ());
  expectNear(found.simplex.pointOnA(), {0.25, 0, 0}, "point on a, in its frame");
  expectNear(found.simplex.pointOnB(), {0, -0.5, 0}, "point on b, in its frame");
}

TEST(Gjk, boxesCornerToCorner_settleAtTheCorners) {
  const GjkResult found = runCold(pairFrom(boxCore(1, 1, 1), boxCore(1, 1, 1), 3, 4, 4));
  expectSettled(found, 3.0, Vector3d(1, 2, 2) / 3.0);
  expectNear(found.simplex.pointOnA(), {1, 1, 1}, "point on a");
  expectNear(found.simplex.pointOnB(), {-1, -1, -1}, "point on b");
}

TEST(Gjk, facesThatTouch_overlap) {
  EXPECT_EQ(runCold(pairFrom(boxCore(1, 1, 1), boxCore(1, 1, 1), 2, 0.5, 0)).state,
            GjkState::overlapping);
}

TEST(Gjk, fartherThanTheCutoff_stopsWithAProof) {
  const ConvexPair pair = pairFrom(boxCore(1, 1, 1), boxCore(1, 1, 1), 3.5, 0.5, 0);
  expectSettled(runCold(pair), 1.5, Vector3d::UnitX());
  const GjkResult found = runCold(pair, 0.5);
  EXPECT_EQ(found.state, GjkState::stopped);
  EXPECT_GE(found.lower, 0.5);
  EXPECT_LT(found.lower, 1.5);
  EXPECT_GE(found.simplex.distance, 1.5);
}

TEST(Gjk, pointBesideACylinder_settlesAtItsSide) {
  const ConvexCore cylinder{ConvexCore::Kind::cylinder, {1, 1, 0.5}};
  expectSettled(runCold(pairFrom(cylinder, boxCore(0, 0, 0), 3, 4, 0.25)), 4.0, {0.6, 0.8, 0});
}

TEST(Gjk, octahedronBesideAPoint_settlesAtItsFace) {
  const ConvexHull solid({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}});
  const ConvexCore hull{ConvexCore::Kind::hull, Vector3d::Zero(), &solid};
  // The face x + y + z = 1 is 2 / sqrt(3) from a point of which the sum is 3.
  const GjkResult found = runCold(pairFrom(hull, boxCore(0, 0, 0), 1, 1, 1));
  expectSettled(found, 2.0 / std::sqrt(3.0), Vector3d::Ones().normalized());
  expectNear(found.simplex.pointOnA(), Vector3d::Ones() / 3.0, "point on a");
}

TEST(Gjk, warmStartThatIsStale_isNoneTheWorse) {
  ConvexPair pair = pairFrom(boxCore(1, 1, 1), boxCore(1, 1, 1), 3, 4, 4);
  const GjkResult before = runGjk(pair, ConvexWarmStart(), {});
  ConvexWarmStart warm;
  keepWarm(before.simplex.vertices.data(), before.simplex.size, pair, warm);
  ASSERT_EQ(warm.size, 1U) << "a corner of each";
  ConvexPair same = pairFrom(boxCore(1, 1, 1), boxCore(1, 1, 1), 3, 4, 4);
  expectSettled(runGjk(same, warm, {}), 3.0, Vector3d(1, 2, 2) / 3.0);
  ConvexPair elsewhere = pairFrom(boxCore(1, 1, 1), boxCore(1, 1, 1), -4, 0.25, 0.5);
  expectSettled(runGjk(elsewhere, warm, {}), 2.0, -Vector3d::UnitX());
}

}  // namespace
}  // namespace collision_monitor::test
