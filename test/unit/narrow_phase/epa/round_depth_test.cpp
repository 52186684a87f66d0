// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "support/convex_cases.h"
#include "support/reference/convex_measure.h"

// Round things that overlap with axes all but coincident: every direction across them is about
// equally deep, and a polytope that is grown runs out of room.
namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

constexpr double kClose = 1e-9;  // a polytope that finds room settles for 1e-10 of the sizes

Pose tilted(double angle, const Vector3d& center) {
  return {Eigen::AngleAxisd(angle, Vector3d::UnitY()).toRotationMatrix(), center};
}

void expectDepth(const ConvexGeometry& a, const ConvexGeometry& b, const Pose& a_from_b,
                 double depth) {
  const Pose world_from_a = tilted(0.7, {0.3, -0.2, 1.0});
  const Pose world_from_b = world_from_a * a_from_b;
  for (const bool is_swapped : {false, true}) {
    const PosedConvexPair pair = is_swapped ? PosedConvexPair{&b, world_from_b, &a, world_from_a}
                                            : PosedConvexPair{&a, world_from_a, &b, world_from_b};
    const ConvexDistance found =
        measureCold(*pair.a, pair.world_from_a, *pair.b, pair.world_from_b);
    EXPECT_EQ(found.quality, Quality::exact);
    EXPECT_NEAR(found.measured.distance, -depth, kClose);
    const ConvexCertificate proof = certify(pair, found.measured);
    EXPECT_NEAR(proof.gap_along_normal, -depth, kClose);
    EXPECT_LE(std::max(proof.a_outside, proof.b_outside), kClose);
  }
}

const Cylinder kThick{0.5, 0.1};
const Cylinder kThin{0.7, 0.05};

TEST(RoundDepth, crossedAtTheirCenters_acrossBothAxes) {
  for (const double angle : {1e-3, 1e-6, 1e-9, 1e-12}) {
    expectDepth(kThick, kThin, tilted(angle, {0, 0, 0}), 0.15);
  }
}

TEST(RoundDepth, aLittleBesideEachOther_lessByThat) {
  expectDepth(kThick, kThin, tilted(1e-4, {0, 1e-5, 0.1}), 0.14999);
}

TEST(RoundDepth, segmentInCylinder_acrossBothAxes) {
  expectDepth(kThick, Capsule{0.3, 0.02}, tilted(1e-4, {0, 1e-6, 0}), 0.119999);
}

TEST(RoundDepth, inThePlaneOfTheAxes_acrossTheLonger) {
  // Off B's side comes A's lower rim, which leans towards it.
  const double angle = 1e-3;
  const double offset = 0.01;
  expectDepth(kThick, kThin, tilted(angle, {offset, 0, 0}),
              kThin.radius + (kThick.radius - offset) * std::cos(angle) +
                  kThick.half_length * std::sin(angle));
}

}  // namespace
}  // namespace collision_monitor::test
