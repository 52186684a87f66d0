// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/confirm_depth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "narrow_phase/convex_core.h"
#include "support/convex_measure.h"
#include "support/expect_distance.h"
#include "support/sample_meshes.h"

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

// An octahedron with corners at 1 along the axes, and a box, of half edge 2, whose face x = 2 it
// pierces with its corner at -x.
class OverlapInSteps : public testing::Test {
 protected:
  void SetUp() override { measure(0.0); }

  Pose poseAt(double x) const { return at(2.5 + x, 0.25, 0.125); }

  SignedDistance measure(double x) {
    static ConvexWorkspace workspace;
    ConvexSearch search{workspace, warm_};
    const ConvexDistance found =
        signedDistanceBetween(box_, Pose{}, octahedron_, poseAt(x), search);
    EXPECT_EQ(found.quality, DistanceQuality::exact);
    return found.measured;
  }

  bool confirm(const Pose& pose) {
    const ConvexCore a = sweptCoreOf(box_).core;
    const ConvexCore b = sweptCoreOf(octahedron_).core;
    const Pose origin;
    return confirmDepth(
        makePlacedPair({a, origin, warm_.vertex_of_a}, {b, pose, warm_.vertex_of_b}), warm_,
        found_);
  }

  const Box box_{{2, 2, 2}};
  const ConvexHull octahedron_{
      {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
  ConvexWarmStart warm_;
  SignedDistance found_;
};

TEST_F(OverlapInSteps, faceOfTheLastStep_isProven) {
  ASSERT_GT(warm_.inside.face_count, 3);
  for (const double x : {0.0, 0.1, -0.2, 0.45}) {
    ASSERT_TRUE(confirm(poseAt(x))) << x;
    EXPECT_NEAR(found_.distance, x - 0.5, kExact);
    expectNear(found_.normal_a_to_b, Vector3d::UnitX(), "normal");
    expectNear(found_.point_on_a, {2, 0.25, 0.125}, "on a");
    expectNear(found_.point_on_b, {1.5 + x, 0.25, 0.125}, "on b");
  }
}

TEST_F(OverlapInSteps, apartOrTouching_isLeftToTheSearch) {
  EXPECT_FALSE(confirm(poseAt(0.5)));
  EXPECT_FALSE(confirm(poseAt(0.75)));
  EXPECT_FALSE(confirm(poseAt(9.0)));
}

TEST_F(OverlapInSteps, shorterWayOutElsewhere_isLeftToTheSearch) {
  EXPECT_FALSE(confirm(at(0.5, 2.75, 0.125)));
  // The same by the whole search: out along y.
  EXPECT_NEAR(measureCold(box_, Pose{}, octahedron_, at(0.5, 2.75, 0.125)).measured.distance, -0.25,
              kExact);
}

TEST_F(OverlapInSteps, poseThatIsNotFinite_provesNothing) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    for (Eigen::Index entry = 0; entry < 12; ++entry) {
      Pose pose = poseAt(0.0);
      (entry < 9 ? pose.rotation.data()[entry] : pose.translation[entry - 9]) = bad;
      EXPECT_FALSE(confirm(pose)) << entry;
    }
  }
}

TEST_F(OverlapInSteps, pairThatCameApart_forgetsThePolytope) {
  EXPECT_NEAR(measure(1.0).distance, 0.5, kExact);
  EXPECT_EQ(warm_.inside.face_count, 0);
  EXPECT_NEAR(measure(0.25).distance, -0.25, kExact);
  EXPECT_GT(warm_.inside.face_count, 3);
}

}  // namespace
}  // namespace collision_monitor::test
