// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/warm_start/depth_from_warm_start.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision_monitor/narrow_phase/convex_distance.h"
#include "narrow_phase/gjk/convex_core.h"
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
    EXPECT_EQ(found.quality, Quality::exact);
    return found.measured;
  }

  std::optional<WarmStartDistance> confirm(const Pose& pose) {
    const ConvexCore a = inflatedCoreOf(box_).core;
    const ConvexCore b = inflatedCoreOf(octahedron_).core;
    const Pose origin;
    const PlacedCore placed_a{a, origin, warm_.vertex_of_a};
    const PlacedCore placed_b{b, pose, warm_.vertex_of_b};
    return depthFromWarmStart(makePlacedPair(placed_a, placed_b), warm_);
  }

  const Box box_{{2, 2, 2}};
  const ConvexHull octahedron_{
      {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
  ConvexWarmStart warm_;
};

TEST_F(OverlapInSteps, faceOfTheLastStep_isProven) {
  ASSERT_GT(warm_.polytope_faces, 3);
  for (const double x : {0.0, 0.1, -0.2, 0.45}) {
    const auto found = confirm(poseAt(x));
    ASSERT_TRUE(found) << x;
    EXPECT_NEAR(found->cores.distance, x - 0.5, kExact);
    expectNear(found->cores.normal_a_to_b, Vector3d::UnitX(), "normal");
    expectNear(found->cores.point_on_a, {2, 0.25, 0.125}, "on a");
    expectNear(found->cores.point_on_b, {1.5 + x, 0.25, 0.125}, "on b");
  }
}

TEST_F(OverlapInSteps, apartOrTouching_isLeftToTheSearch) {
  EXPECT_FALSE(confirm(poseAt(0.5)));
  EXPECT_FALSE(confirm(poseAt(0.75)));
  EXPECT_FALSE(confirm(poseAt(9.0)));
}

// Out along y: the polytope of the last step has to grow by corners that several of its faces see.
TEST_F(OverlapInSteps, shorterWayOutElsewhere_isGrownTo) {
  const auto found = confirm(at(0.5, 2.75, 0.125));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->cores.distance, -0.25, kExact);
  expectNear(found->cores.normal_a_to_b, Vector3d::UnitY(), "normal");
  expectNear(found->cores.point_on_a, {0.5, 2.0, 0.125}, "on a");
}

// Corners that no face has any more stand before those that one has.
TEST_F(OverlapInSteps, polytopeThatHasNoRoomLeft_dropsCornersOfNoFace) {
  ConvexWarmStart::CachedPolytope& kept = warm_.polytope;
  const auto unused = static_cast<std::uint8_t>(ConvexWarmStart::CachedPolytope::kMaxCorners -
                                                warm_.polytope_corners);
  std::rotate(kept.corners.begin(), kept.corners.begin() + warm_.polytope_corners,
              kept.corners.end());
  for (std::size_t f = 0; f < warm_.polytope_faces; ++f) {
    for (std::uint8_t& corner : kept.faces[f]) {
      corner = static_cast<std::uint8_t>(corner + unused);
    }
  }
  warm_.polytope_corners = ConvexWarmStart::CachedPolytope::kMaxCorners;
  const auto found = confirm(at(0.5, 2.75, 0.125));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->cores.distance, -0.25, kExact);
  expectNear(found->cores.normal_a_to_b, Vector3d::UnitY(), "normal");
  EXPECT_LT(warm_.polytope_corners, ConvexWarmStart::CachedPolytope::kMaxCorners);
}

// A cube of half edge 1 behind the face x = 2, first by 0.25 and then by 0.3.
TEST_F(OverlapInSteps, levelFaces_areProvenAndMeetInTheirMiddle) {
  const ConvexHull cube({{-1, -1, -1},
                         {1, -1, -1},
                         {-1, 1, -1},
                         {1, 1, -1},
                         {-1, -1, 1},
                         {1, -1, 1},
                         {-1, 1, 1},
                         {1, 1, 1}});
  static ConvexWorkspace workspace;
  ConvexWarmStart warm;
  ConvexSearch search{workspace, warm};
  signedDistanceBetween(box_, Pose{}, cube, at(2.75, 0.25, 0.125), search);
  ASSERT_GT(warm.polytope_faces, 3);
  const Pose pose = at(2.7, 1.5, 0.1);
  const Pose origin;
  const ConvexCore a = inflatedCoreOf(box_).core;
  const ConvexCore b = inflatedCoreOf(cube).core;
  const PlacedCore placed_a{a, origin, warm.vertex_of_a};
  const PlacedCore placed_b{b, pose, warm.vertex_of_b};
  const auto found = depthFromWarmStart(makePlacedPair(placed_a, placed_b), warm);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->is_level);
  EXPECT_NEAR(found->cores.distance, -0.3, kExact);
  // They share y from 0.5 to 2, and z from -0.9 to 1.1.
  const SignedDistance measured = signedDistanceBetween(box_, Pose{}, cube, pose, search).measured;
  expectNear(measured.point_on_a, {2, 1.25, 0.1}, "on a");
  expectNear(measured.point_on_b, {1.7, 1.25, 0.1}, "on b");
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
  EXPECT_EQ(warm_.polytope_faces, 0);
  EXPECT_NEAR(measure(0.25).distance, -0.25, kExact);
  EXPECT_GT(warm_.polytope_faces, 3);
}

}  // namespace
}  // namespace collision_monitor::test
