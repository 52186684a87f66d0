// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/warm_start/distance_from_warm_start.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "geometry/constants.h"
#include "narrow_phase/gjk/convex_core.h"
#include "support/expect_distance.h"
#include "support/sample_meshes.h"

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

using Confirmed = std::optional<WarmStartDistance>;

template <class A, class B>
Confirmed confirm(const A& a, const Pose& pose_a, const B& b, const Pose& pose_b,
                  ConvexWarmStart warm) {
  const ConvexCore core_a = inflatedCoreOf(a).core;
  const ConvexCore core_b = inflatedCoreOf(b).core;
  return distanceFromWarmStart({core_a, pose_a, warm.vertex_of_a},
                               {core_b, pose_b, warm.vertex_of_b}, warm);
}

void expectProven(const Confirmed& found, double distance, const Vector3d& on_a,
                  const Vector3d& on_b) {
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->cores.distance, distance, kExact);
  expectNear(found->cores.point_on_a, on_a, "on a");
  expectNear(found->cores.point_on_b, on_b, "on b");
  expectConsistent(found->cores);
  EXPECT_FALSE(found->is_level);
}

ConvexWarmStart endsAt(std::initializer_list<ConvexWarmStart::Ends> ends) {
  ConvexWarmStart warm;
  for (const ConvexWarmStart::Ends& end : ends) {
    warm.ends[warm.size++] = end;
  }
  return warm;
}

class CubesInSteps : public testing::Test {
 protected:
  const ConvexHull cube_{boxMesh({1, 1, 1}).vertices};
  const Box box_{{1, 1, 1}};
  const ConvexWarmStart corners_ = endsAt({{{1, 1, 1}, {-1, -1, -1}}});
};

TEST_F(CubesInSteps, cornersOfTheLastStep_areProven) {
  const Pose b = at(4, 5, 5);
  expectProven(confirm(cube_, Pose{}, cube_, b, corners_), std::sqrt(22.0), {1, 1, 1}, {3, 4, 4});
  expectProven(confirm(cube_, at(1, 0, 0), box_, at(5, 5, 5), corners_), std::sqrt(22.0), {2, 1, 1},
               {4, 4, 4});
  expectProven(confirm(box_, Pose{}, Sphere{1}, at(2, 3, 3), endsAt({{{1, 1, 1}, {0, 0, 0}}})), 3.0,
               {1, 1, 1}, {2, 3, 3});
}

TEST_F(CubesInSteps, edgeAndFaceOfTheLastStep_areProven) {
  const ConvexWarmStart edge = endsAt({{{1, 1, -1}, {0, 0, 0}}, {{1, 1, 1}, {0, 0, 0}}});
  expectProven(confirm(cube_, Pose{}, Sphere{1}, at(4, 5, 0.5), edge), 5.0, {1, 1, 0.5},
               {4, 5, 0.5});
  const ConvexWarmStart face =
      endsAt({{{1, -1, -1}, {0, 0, 0}}, {{1, 1, -1}, {0, 0, 0}}, {{1, 1, 1}, {0, 0, 0}}});
  expectProven(confirm(cube_, Pose{}, Sphere{1}, at(3, 0.5, 0.25), face), 2.0, {1, 0.5, 0.25},
               {3, 0.5, 0.25});
}

TEST_F(CubesInSteps, otherCornersNearer_areFound) {
  expectProven(confirm(cube_, Pose{}, cube_, at(-4, 5, 5), corners_), std::sqrt(22.0), {-1, 1, 1},
               {-3, 4, 4});
  const ConvexWarmStart edge = endsAt({{{1, 1, -1}, {0, 0, 0}}, {{1, 1, 1}, {0, 0, 0}}});
  expectProven(confirm(cube_, Pose{}, Sphere{1}, at(3, 4, 7), edge), 7.0, {1, 1, 1}, {3, 4, 7});
  expectProven(confirm(cube_, Pose{}, Sphere{1}, at(0.25, 0.5, 4), edge), 3.0, {0.25, 0.5, 1},
               {0.25, 0.5, 4});
}

// Edges along y are nearest, and in the last case faces: any of their points would do.
TEST_F(CubesInSteps, parallelFeatures_areProvenAndToldLevel) {
  for (const Confirmed& found : {confirm(cube_, Pose{}, cube_, at(4, 2, 5), corners_),
                                 confirm(cube_, Pose{}, box_, at(4, 0, 5), corners_)}) {
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->is_level);
    EXPECT_NEAR(found->cores.distance, std::sqrt(13.0), kExact);
    expectConsistent(found->cores);
  }
  // A corner of one face over the other face.
  const ConvexWarmStart face =
      endsAt({{{1, -1, -1}, {-1, -1, -1}}, {{1, 1, -1}, {-1, -1, -1}}, {{1, 1, 1}, {-1, -1, -1}}});
  const Confirmed faces = confirm(cube_, Pose{}, cube_, at(4, 0.5, 0.25), face);
  ASSERT_TRUE(faces);
  EXPECT_TRUE(faces->is_level);
  EXPECT_NEAR(faces->cores.distance, 2.0, kExact);
}

TEST_F(CubesInSteps, touchingAndOverlapping_areLeftToTheSearch) {
  EXPECT_FALSE(confirm(cube_, Pose{}, cube_, at(2, 2, 2), corners_));
  EXPECT_FALSE(confirm(cube_, Pose{}, cube_, at(1, 1.5, 1.5), corners_));
}

TEST_F(CubesInSteps, nothingFoundBefore_isLeftToTheSearch) {
  EXPECT_FALSE(confirm(cube_, Pose{}, cube_, at(4, 5, 5), ConvexWarmStart{}));
}

void setEntry(Pose& pose, Eigen::Index entry, double value) {
  (entry < 9 ? pose.rotation.data()[entry] : pose.translation[entry - 9]) = value;
}

TEST_F(CubesInSteps, poseThatIsNotFinite_provesNothing) {
  const ConvexWarmStart of_can = endsAt({{{1, 0, 1}, {-1, -1, -1}}});
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    for (Eigen::Index entry = 0; entry < 12; ++entry) {
      Pose pose = at(4, 5, 5);
      setEntry(pose, entry, bad);
      EXPECT_FALSE(confirm(cube_, Pose{}, cube_, pose, corners_)) << entry;
      EXPECT_FALSE(confirm(cube_, pose, Sphere{1}, at(9, 9, 9), corners_)) << entry;
      EXPECT_FALSE(confirm(Cylinder{1, 1}, Pose{}, cube_, pose, of_can)) << entry;
      EXPECT_FALSE(confirm(cube_, pose, Cylinder{1, 1}, Pose{}, corners_)) << entry;
    }
  }
}

// Radius and half length 1; its rim at z = 1 goes through (0.6, 0.8, 1).
class CanInSteps : public testing::Test {
 protected:
  const Cylinder can_{1, 1};
  const ConvexHull cube_{boxMesh({1, 1, 1}).vertices};
};

TEST_F(CanInSteps, cornerOverTheRim_isProven) {
  const ConvexWarmStart warm = endsAt({{{1, 0, 1}, {-1, -1, -1}}});
  // The corner at (2.4, 3.2, 5): 3 outward and 4 up from the rim.
  expectProven(confirm(can_, Pose{}, cube_, at(3.4, 4.2, 6), warm), 5.0, {0.6, 0.8, 1},
               {2.4, 3.2, 5});
}

TEST_F(CanInSteps, sphere_isProvenWithoutALastStep) {
  const ConvexWarmStart none = endsAt({});
  expectProven(confirm(can_, Pose{}, Sphere{1}, at(2.4, 3.2, 5), none), 5.0, {0.6, 0.8, 1},
               {2.4, 3.2, 5});
  // Beside the side and over the cap, from the can's frame turned by a quarter.
  const Pose lying{Eigen::AngleAxisd(0.5 * kPi, Vector3d::UnitX()).toRotationMatrix(), {0, 0, 5}};
  expectProven(confirm(Sphere{1}, at(0, 0.5, 9), can_, lying, none), 3.0, {0, 0.5, 9}, {0, 0.5, 6});
  expectProven(confirm(Sphere{1}, at(0.25, -4, 5), can_, lying, none), 3.0, {0.25, -4, 5},
               {0.25, -1, 5});
}

TEST_F(CanInSteps, sphereWhoseCenterIsInside_isLeftToTheSearch) {
  const ConvexWarmStart none = endsAt({});
  EXPECT_FALSE(confirm(can_, Pose{}, Sphere{1}, at(0.5, 0.25, 0.5), none));
  EXPECT_FALSE(confirm(can_, Pose{}, Sphere{1}, at(0.6, 0.8, 0.5), none));
  EXPECT_FALSE(confirm(Sphere{1}, at(std::nan(""), 3, 0), can_, Pose{}, none));
}

TEST_F(CanInSteps, cornerThatHasBecomeAnEdge_isFollowed) {
  // The edge along y at (4, y, 5), of which the last search knew one end.
  const ConvexWarmStart warm = endsAt({{{-1, -1, -1}, {1, 0, 1}}});
  expectProven(confirm(cube_, at(5, 0.25, 6), can_, Pose{}, warm), 5.0, {4, 0, 5}, {1, 0, 1});
}

TEST_F(CanInSteps, rimUnderAFace_isProven) {
  // The can stands on its rim, an eighth turned, below the cube's face at z = 3.
  const double s = std::sqrt(0.5);
  const Pose tilted{axes({s, 0, -s}, Vector3d::UnitY()), Vector3d::Zero()};
  const ConvexWarmStart warm =
      endsAt({{{1, 0, 1}, {-1, -1, -1}}, {{1, 0, 1}, {1, -1, -1}}, {{1, 0, 1}, {1, 1, -1}}});
  const double top = std::sqrt(2.0);
  const Confirmed found = confirm(can_, tilted, cube_, at(0.25, 0.5, 4), warm);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->cores.distance, 3.0 - top, kExact);
  expectNear(found->cores.normal_a_to_b, Vector3d::UnitZ(), "normal");
}

TEST_F(CanInSteps, rimOfOneBesideAnother_isFollowed) {
  // B lies along x, its rim at x = 3 nearest with (3, 1.5, 0.5).
  const Pose lying{zToX(), {4, 2.5, 0.5}};
  const ConvexWarmStart warm = endsAt({{{1, 0, 0.5}, {-0.8, 0.6, -1}}});
  const double off_axis = std::sqrt(11.25);
  expectProven(confirm(can_, Pose{}, can_, lying, warm), off_axis - 1.0,
               {3.0 / off_axis, 1.5 / off_axis, 0.5}, {3, 1.5, 0.5});
}

TEST_F(CanInSteps, sidesOfTwo_areFollowed) {
  const Pose across{zToX(), {0, 5, 0.25}};
  const ConvexWarmStart warm = endsAt({{{0, 1, 0.1}, {-1, 0, 0.2}}});
  expectProven(confirm(can_, Pose{}, can_, across, warm), 3.0, {0, 1, 0.25}, {0, 4, 0.25});
}

// A point one radius off the end of B's axis would be nearer than any of B is.
TEST_F(CanInSteps, sideThatHasBecomeARim_isLeftToTheSearch) {
  const Pose past_its_end{zToX(), {4, 3, 1.5}};
  const ConvexWarmStart warm = endsAt({{{1, 0, 0}, {0, 1, 0.2}}});
  EXPECT_FALSE(confirm(can_, Pose{}, can_, past_its_end, warm));
}

TEST_F(CanInSteps, parallelSides_areLeftToTheSearch) {
  const ConvexWarmStart warm = endsAt({{{1, 0, 0.5}, {-1, 0, 0.5}}});
  EXPECT_FALSE(confirm(can_, Pose{}, can_, at(4, 0, 0.5), warm));
}

}  // namespace
}  // namespace collision_monitor::test
