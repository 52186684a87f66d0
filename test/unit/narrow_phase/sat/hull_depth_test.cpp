// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/sat/hull_depth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "collision_monitor/narrow_phase/convex_distance.h"
#include "narrow_phase/gjk/convex_core.h"
#include "support/expect_distance.h"
#include "support/reference/convex_measure.h"
#include "support/sample_meshes.h"

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

class HullDepth : public testing::Test {
 protected:
  ConvexPair pairOf(const ConvexHull& a, const Pose& pose_a, const ConvexHull& b,
                    const Pose& pose_b) const {
    return makeConvexPair(inflatedCoreOf(a).core, pose_a, inflatedCoreOf(b).core, pose_b);
  }

  bool isTold(const ConvexHull& a, const Pose& pose_a, const ConvexHull& b,
              const Pose& pose_b) const {
    ConvexPair pair = pairOf(a, pose_a, b, pose_b);
    SignedDistance found;
    return depthOfHulls(pair, found);
  }

  void expectDeep(const ConvexHull& a, const Pose& pose_a, const ConvexHull& b, const Pose& pose_b,
                  double depth, const Vector3d& on_a, const Vector3d& normal) const {
    ConvexPair pair = pairOf(a, pose_a, b, pose_b);
    SignedDistance found;
    ASSERT_TRUE(depthOfHulls(pair, found));
    found = placed(pose_a, found);
    EXPECT_NEAR(found.distance, -depth, 1e-15);
    expectNear(found.point_on_a, on_a, "on a");
    expectNear(found.normal_a_to_b, normal, "normal");
    expectConsistent(found);
  }

  const double s_ = std::sqrt(0.5);
  const ConvexHull cube_{boxMesh({1, 1, 1}).vertices};
  // Stands on its tip (0, 0, 0.7).
  const ConvexHull spike_{std::vector<Vector3d>{{0, 0, 0.7}, {1, 0, 2}, {-1, 1, 2}, {-1, -1, 2}}};
  // Stands on its ridge along y, at z = 0.
  const ConvexHull wedge_{std::vector<Vector3d>{
      {0, -0.5, 0}, {0, 0.25, 0}, {-1, -0.5, 2}, {-1, 0.25, 2}, {1, -0.5, 2}, {1, 0.25, 2}}};
};

TEST_F(HullDepth, vertexUnderAFaceOfEither_pointsUnderTheVertex) {
  expectDeep(cube_, Pose{}, spike_, Pose{}, 0.3, {0, 0, 1}, {0, 0, 1});
  expectDeep(spike_, Pose{}, cube_, Pose{}, 0.3, {0, 0, 0.7}, {0, 0, -1});
  const Pose moved{axes({0, 1, 0}, {0, 0, 1}), {3, -2, 0.5}};
  expectDeep(cube_, moved, spike_, moved, 0.3, {4, -2, 0.5}, {1, 0, 0});
}

TEST_F(HullDepth, crossedEdges_endsOfTheirCommonPerpendicular) {
  const Pose lower{axes({s_, 0, s_}, {0, 1, 0}), {0.25, 0, 0}};
  const Pose upper{axes({1, 0, 0}, {0, s_, s_}), {0, 0.5, 2.0 * std::sqrt(2.0) - 0.1}};
  expectDeep(cube_, lower, cube_, upper, 0.1, {0.25, 0.5, std::sqrt(2.0)}, {0, 0, 1});
}

TEST_F(HullDepth, edgeOrFaceOverAFace_middleOfWhatTheyShare) {
  expectDeep(cube_, Pose{}, wedge_, at(0.25, 0, 0.9), 0.1, {0.25, -0.125, 1}, {0, 0, 1});
  expectDeep(cube_, Pose{}, wedge_, at(0.25, 1, 0.9), 0.1, {0.25, 0.75, 1}, {0, 0, 1});
  expectDeep(cube_, Pose{}, cube_, at(0.5, 1.25, 1.875), 0.125, {0.25, 0.625, 1}, {0, 0, 1});
}

TEST_F(HullDepth, apartOrTouching_leftToTheSearch) {
  EXPECT_FALSE(isTold(cube_, Pose{}, spike_, at(0, 0, 0.4)));
  EXPECT_FALSE(isTold(cube_, Pose{}, cube_, at(2, 0, 0)));
  EXPECT_FALSE(isTold(cube_, Pose{}, cube_, at(2.5, 0.5, 0)));
  EXPECT_TRUE(isTold(cube_, Pose{}, cube_, at(1.999999, 0, 0)));
}

// The ridge falls by 1e-9 towards its end, which is just beyond the cube's top. There the cube's
// edge tells the depth, and its top the same but for 1e-17 m.
TEST_F(HullDepth, tieOfAFaceAndAnEdge_noPointBesideTheFace) {
  for (int i = 1; i <= 100; ++i) {
    const double overhang = 1e-10 * i;
    const ConvexHull beyond(std::vector<Vector3d>{{0, 1 + overhang, 0},
                                                  {0, -0.5, 1.5e-9},
                                                  {-1, 1, 2},
                                                  {-1, -0.5, 2},
                                                  {1, 1, 2},
                                                  {1, -0.5, 2}});
    ConvexPair pair = pairOf(cube_, Pose{}, beyond, at(0, 0, 0.9));
    SignedDistance found;
    if (depthOfHulls(pair, found)) {
      EXPECT_LE(found.point_on_a.cwiseAbs().maxCoeff(), 1.0 + kExact) << i;
    }
    const ConvexDistance answer = measureCold(cube_, Pose{}, beyond, at(0, 0, 0.9));
    EXPECT_EQ(answer.quality, Quality::exact);
    EXPECT_NEAR(answer.measured.distance, -0.1, 1e-15);
    expectNear(answer.measured.point_on_a, {0, 1, 1}, "on a");
  }
}

TEST_F(HullDepth, fewFaces_ofBothTogether) {
  const ConvexHull prism(prismMesh(1.0, 1.0, 18).vertices);  // 20 faces
  const ConvexHull plate(std::vector<Vector3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  EXPECT_TRUE(haveFewFaces(pairOf(cube_, Pose{}, prism, Pose{})));
  EXPECT_TRUE(haveFewFaces(pairOf(prism, Pose{}, prism, Pose{})));
  const ConvexHull ball(sphereMesh(1.0, 8).vertices);
  EXPECT_FALSE(haveFewFaces(pairOf(prism, Pose{}, ball, Pose{})));
  EXPECT_FALSE(haveFewFaces(pairOf(cube_, Pose{}, plate, Pose{})));
}

// GJK and EPA answer the same by steps, and leave a polytope.
TEST_F(HullDepth, firstQueryOfAPair_isAnsweredByAxes) {
  static ConvexWorkspace workspace;
  ConvexWarmStart warm;
  ConvexSearch search{workspace, warm};
  const ConvexGeometry cube = cube_;
  const ConvexGeometry spike = spike_;
  for (const bool is_first : {true, false}) {
    const ConvexDistance found = signedDistanceBetween(cube, Pose{}, spike, Pose{}, search);
    EXPECT_EQ(found.quality, Quality::exact);
    EXPECT_NEAR(found.measured.distance, -0.3, 1e-15);
    expectNear(found.measured.point_on_b, {0, 0, 0.7}, "on b");
    EXPECT_EQ(warm.polytope_faces == 0, is_first);
  }
}

}  // namespace
}  // namespace collision_monitor::test
