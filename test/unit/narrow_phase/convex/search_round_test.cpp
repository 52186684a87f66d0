// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/convex/search_round.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "support/expect_distance.h"

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

const ConvexCore kRoundCore{ConvexCore::Kind::cylinder, {0.5, 0.5, 1.0}};
const ConvexCore kBoxCore{ConvexCore::Kind::box, {1.0, 1.0, 1.0}};

/// A search without a warm start, and what pure GJK finds.
struct Searched {
  bool is_early{false};
  GjkResult found;
  SignedDistance measured;
  GjkResult full;
};

Searched search(const ConvexCore& a, const ConvexCore& b, const Pose& a_from_b) {
  static ConvexWorkspace workspace;
  ConvexWarmStart warm;
  ConvexSearch convex{workspace, warm};
  ConvexPair pair = makeConvexPair(a, Pose(), b, a_from_b);
  Searched searched;
  searched.is_early = searchRound(pair, convex, searched.found, searched.measured);
  searched.full = runGjk(pair, ConvexWarmStart(), {});
  return searched;
}

void expectEarly(const Searched& searched, double distance) {
  EXPECT_TRUE(searched.is_early);
  EXPECT_NEAR(searched.measured.distance, distance, kExact);
  EXPECT_LT(searched.found.steps, searched.full.steps);
  EXPECT_NEAR(searched.full.simplex.distance, distance, 1e-9);
  expectConsistent(searched.measured);
}

Pose turnedAboutY(double angle, const Vector3d& translation) {
  return {Eigen::AngleAxisd(angle, Vector3d::UnitY()).toRotationMatrix(), translation};
}

TEST(SearchRound, sideAcrossACap_isAsFarAsTheirPlanes) {
  const Searched searched =
      search(kRoundCore, kRoundCore, turnedAboutY(std::acos(0.0), {0.4, 0.3, 2.0}));
  expectEarly(searched, 0.5);
  expectNear(searched.measured.normal_a_to_b, Vector3d::UnitZ(), "normal");
}

TEST(SearchRound, sideOverAFace_isAsFarAsTheirPlanes) {
  const Pose lying = turnedAboutY(std::acos(0.0), {0.3, 0.4, 1.75});
  const Searched searched = search(kBoxCore, kRoundCore, lying);
  expectEarly(searched, 0.25);
  expectNear(searched.measured.normal_a_to_b, Vector3d::UnitZ(), "normal");
}

TEST(SearchRound, levelSideBeyondTheCap_isNotAsFarAsTheirPlanes) {
  // The rims are nearest: across the axes there is 0.5 m, but nothing of one is over the other.
  const Searched searched =
      search(kRoundCore, kRoundCore, turnedAboutY(std::acos(0.0), {0.0, 3.0, 2.0}));
  EXPECT_TRUE(searched.is_early);
  EXPECT_GT(searched.measured.distance, 1.5);
  EXPECT_NEAR(searched.measured.distance, searched.full.simplex.distance, 1e-9);
}

TEST(SearchRound, overlapping_isLeftToGjk) {
  const Searched searched = search(kRoundCore, kRoundCore, turnedAboutY(0.7, {0.3, 0.2, 0.4}));
  EXPECT_FALSE(searched.is_early);
  EXPECT_EQ(searched.found.state, GjkResult::State::overlapping);
}

TEST(SearchRound, skewCans_mostlyEndEarly_andAreAsFarAsByGjkAlone) {
  int early = 0;
  constexpr int kPoses = 500;
  for (int i = 0; i < kPoses; ++i) {
    const Vector3d away = 3.0 * Vector3d(std::cos(i), std::sin(i), std::sin(1.7 * i)).normalized();
    const Searched searched = search(kRoundCore, kRoundCore, turnedAboutY(0.37 * i, away));
    early += searched.is_early ? 1 : 0;
    const double distance =
        searched.is_early ? searched.measured.distance : searched.found.simplex.distance;
    EXPECT_NEAR(distance, searched.full.simplex.distance, 2e-9) << i;
  }
  EXPECT_GE(early, kPoses * 9 / 10);
}

}  // namespace
}  // namespace collision_monitor::test
