// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "motion/mesh_clearance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "support/query_meshes.h"
#include "support/sample_meshes.h"

namespace collision_monitor::test {
namespace {

constexpr double kFloats = 1e-7;  ///< [m] corners are stored as floats

Pose at(double x, double y, double z) {
  return {Eigen::Matrix3d::Identity(), Eigen::Vector3d(x, y, z)};
}

RelativeMotion sliding(const Eigen::Vector3d& by) {
  RelativeMotion motion;
  motion.velocity = by;
  return motion;
}

class MeshClearanceTest : public testing::Test {
 protected:
  MeshClearance check(const MeshTree& a, const MeshTree& b, const Pose& world_from_b,
                      const RelativeMotion& motion, double distance) {
    const Pose world_from_a;
    return stayApart({a, world_from_a}, {b, world_from_b}, motion, distance, *memory_);
  }

  /// Two plates of 1 m with a gap of 1 cm.
  MeshTree plate_{boxMesh({0.5, 0.5, 0.01}), true};
  Pose above_ = at(0.0, 0.0, 0.03);
  std::unique_ptr<MeshQueryMemory> memory_ = std::make_unique<MeshQueryMemory>();
};

TEST_F(MeshClearanceTest, platesThatSlide_stayApart) {
  const MeshClearance found = check(plate_, plate_, above_, sliding({0.4, -0.3, 0.0}), 0.009);
  EXPECT_TRUE(found.is_proven);
  EXPECT_GE(found.at_least, 0.009);
  EXPECT_LE(found.at_least, 0.01 + kFloats);
  EXPECT_FALSE(check(plate_, plate_, above_, sliding({0.4, -0.3, 0.0}), 0.011).is_proven);
}

TEST_F(MeshClearanceTest, platesThatApproach_stayApartForAsLongAsTheGapLasts) {
  EXPECT_TRUE(check(plate_, plate_, above_, sliding({0.3, 0.0, -0.004}), 0.005).is_proven);
  EXPECT_FALSE(check(plate_, plate_, above_, sliding({0.3, 0.0, -0.006}), 0.005).is_proven);
  EXPECT_FALSE(check(plate_, plate_, above_, sliding({0.3, 0.0, 0.006}), 0.005).is_proven)
      << "they were nearer before the middle";
}

TEST_F(MeshClearanceTest, whatPathsDeviate_isTakenFromTheGap) {
  RelativeMotion motion = sliding({0.1, 0.0, 0.0});
  motion.turn = Eigen::Vector3d(0.0, 0.0, 0.5);
  motion.center = Eigen::Vector3d(0.5, 0.5, 0.0);
  motion.deviation = 0.004;
  EXPECT_TRUE(check(plate_, plate_, above_, motion, 0.005).is_proven);
  motion.deviation = 0.006;
  EXPECT_FALSE(check(plate_, plate_, above_, motion, 0.005).is_proven);
}

TEST_F(MeshClearanceTest, motionThatIsNotFinite_provesNothing) {
  for (const double number : {std::numeric_limits<double>::infinity(), std::nan("")}) {
    RelativeMotion motion;
    motion.deviation = number;
    EXPECT_FALSE(check(plate_, plate_, above_, motion, 0.0).is_proven) << "deviation " << number;
    EXPECT_FALSE(check(plate_, plate_, above_, sliding({0.0, 0.0, number}), 0.0).is_proven);
  }
}

TEST_F(MeshClearanceTest, aTiltLowersTheFarEnd) {
  RelativeMotion motion;
  motion.turn = Eigen::Vector3d(0.0, 0.01, 0.0);
  motion.center = Eigen::Vector3d(0.5, 0.0, 0.0);
  EXPECT_FALSE(check(plate_, plate_, above_, motion, 0.0).is_proven) << "1 m * 0.01";
  motion.turn *= 0.9;
  EXPECT_TRUE(check(plate_, plate_, above_, motion, 0.0).is_proven);
}

TEST_F(MeshClearanceTest, insideASolid_isNotApart) {
  const MeshTree room(boxMesh({1.0, 1.0, 1.0}), true);
  EXPECT_FALSE(check(room, plate_, at(0.0, 0.0, 0.0), RelativeMotion(), 0.1).is_proven);
  EXPECT_FALSE(check(plate_, room, at(0.0, 0.0, 0.0), RelativeMotion(), 0.1).is_proven);
  const MeshTree walls(boxMesh({1.0, 1.0, 1.0}));
  EXPECT_TRUE(check(walls, plate_, at(0.0, 0.0, 0.0), RelativeMotion(), 0.1).is_proven)
      << "without an inside, only surfaces count";
}

/// A box without a lid, and a small one above its opening.
TEST_F(MeshClearanceTest, anOpenMesh_isEnteredThroughItsHole) {
  TriangleMesh pot = boxMesh({0.1, 0.1, 0.1});
  const auto is_lid = [&](const auto& triangle) {
    return std::all_of(triangle.begin(), triangle.end(),
                       [&](std::uint32_t v) { return pot.vertices[v].z() > 0.0; });
  };
  pot.triangles.erase(std::remove_if(pot.triangles.begin(), pot.triangles.end(), is_lid),
                      pot.triangles.end());
  ASSERT_EQ(pot.triangles.size(), 10U);
  const MeshTree open = openTree(pot);
  const MeshTree small(boxMesh({0.01, 0.01, 0.01}), true);
  const Pose over = at(0.0, 0.0, 0.13);
  EXPECT_TRUE(check(open, small, over, sliding({0.0, 0.0, -0.005}), 0.001).is_proven);
  EXPECT_FALSE(check(open, small, over, sliding({0.0, 0.0, -0.1}), 0.001).is_proven);
  EXPECT_FALSE(check(small, open, at(0.0, 0.0, -0.13), sliding({0.0, 0.0, 0.1}), 0.001).is_proven);
  EXPECT_FALSE(check(open, small, at(0.0, 0.0, 0.0), RelativeMotion(), 0.001).is_proven);
}

}  // namespace
}  // namespace collision_monitor::test
