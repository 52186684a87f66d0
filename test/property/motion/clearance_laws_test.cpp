// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <memory>

#include "motion/convex_clearance.h"
#include "motion/mesh_clearance.h"
#include "support/fixed_seed.h"
#include "support/query_meshes.h"
#include "support/robots/random_motions.h"
#include "support/sample_meshes.h"
#include "support/sanitizer.h"

namespace collision_monitor::test {
namespace {

/// B turns about a center that travels, seen from A.
struct Motion {
  Eigen::Vector3d center;
  Eigen::Vector3d travel;  ///< per half interval
  Eigen::Vector3d turn;

  Pose at(double time, const Pose& world_from_b) const {
    const double angle = turn.norm();
    const Eigen::Matrix3d rotation =
        Eigen::AngleAxisd(time * angle, angle > 0.0 ? Eigen::Vector3d(turn / angle)
                                                    : Eigen::Vector3d::UnitX().eval())
            .toRotationMatrix();
    return {rotation * world_from_b.rotation,
            center + time * travel + rotation * (world_from_b.translation - center)};
  }

  /// @param radius [m] of balls about `center` and the origin that hold B and A
  RelativeMotion linear(double radius) const {
    const double angle = turn.norm();
    const double of_a = radius + center.norm() + travel.norm();
    return {center, travel, turn, 0.5 * angle * angle * radius,
            0.5 * angle * (angle * of_a + 2.0 * travel.norm())};
  }
};

/// @return whether it is proven that two meshes stay apart; if so, they are apart at all times.
bool isProvenAndTrue(const MeshTree& a, const MeshTree& b, const Pose& world_from_b,
                     const Motion& motion, double distance) {
  static const auto memory = std::make_unique<MeshQueryMemory>();
  const Pose world_from_a;
  const MeshClearance found =
      stayApart({a, world_from_a}, {b, world_from_b}, motion.linear(0.8), distance, *memory);
  EXPECT_TRUE(!found.is_proven || found.at_least >= distance);
  for (int k = -10; found.is_proven && k <= 10; ++k) {
    const Pose moved = motion.at(0.1 * k, world_from_b);
    const MeshDistance shown = distanceBetween({a, world_from_a}, {b, moved}, *memory, {}, {});
    EXPECT_EQ(shown.state, MeshState::exact) << k;
    EXPECT_GE(shown.measured.distance, found.at_least - 1e-9) << k;
  }
  return found.is_proven;
}

TEST(ClearanceLaws, whatIsProven_everyTimeShows) {
  Random random(kSeed);
  int proven = 0;
  const int count = caseCount(400);
  for (int i = 0; i < count; ++i) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", case " << i);
    const TriangleMesh bumpy = bumpyMesh(0.4, 12);
    const MeshTree a = i % 2 == 0 ? MeshTree(bumpy, true) : openTree(bumpy);
    const MeshTree b = i % 3 == 0 ? MeshTree(boxMesh({0.2, 0.1, 0.05}), true)
                                  : MeshTree(triangleSoup(0.2, 60, random));
    const Pose world_from_b = randomPose(random, 0.5);
    const double size = uniform(random, 0.0, 1.0);
    const Motion motion{world_from_b.translation, 0.3 * size * randomPoint(random, 1.0),
                        0.5 * size * randomPoint(random, 1.0)};
    proven += isProvenAndTrue(a, b, world_from_b, motion, uniform(random, 0.0, 0.1)) ? 1 : 0;
  }
  EXPECT_GT(proven, count / 5);
  EXPECT_LT(proven, count * 4 / 5);
}

/// A field of 12 x 12 cells and 0.4 m, with hills up to `height` [m].
TriangleMesh hillyField(double height, Random& random) {
  constexpr std::uint32_t kCells = 12;
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i <= kCells; ++i) {
    for (std::uint32_t j = 0; j <= kCells; ++j) {
      mesh.vertices.emplace_back(0.4 * i / kCells - 0.2, 0.4 * j / kCells - 0.2,
                                 height * std::pow(uniform(random, 0.0, 1.0), 8.0));
    }
  }
  for (std::uint32_t i = 0; i < kCells; ++i) {
    for (std::uint32_t j = 0; j < kCells; ++j) {
      const std::uint32_t k = i * (kCells + 1) + j;
      mesh.triangles.push_back({k, k + kCells + 1, k + 1});
      mesh.triangles.push_back({k + 1, k + kCells + 1, k + kCells + 2});
    }
  }
  return mesh;
}

/// One direction parts nearly all triangles of fields that slide over each other, except hills.
TEST(ClearanceLaws, fieldsThatSlide_passOnlyWhereHillsDo) {
  Random random(kSeed + 1);
  int proven = 0;
  const int count = caseCount(400);
  for (int i = 0; i < count; ++i) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed + 1 << ", case " << i);
    const MeshTree a(hillyField(0.02, random));
    const MeshTree b(hillyField(0.02, random));
    Pose world_from_b{Eigen::AngleAxisd(3.14159, Eigen::Vector3d::UnitX()).toRotationMatrix(),
                      Eigen::Vector3d(0.0, 0.0, 0.04)};
    world_from_b.translation +=
        0.1 * randomPoint(random, 1.0).cwiseProduct(Eigen::Vector3d(1.0, 1.0, 0.05));
    const double size = uniform(random, 0.0, 1.0);
    const double turn = i % 2 == 0 ? 0.0 : 0.05 * size;  // half of them deviate
    const Motion motion{
        world_from_b.translation,
        size * randomPoint(random, 1.0).cwiseProduct(Eigen::Vector3d(0.1, 0.1, 0.01)),
        turn * randomPoint(random, 1.0)};
    proven += isProvenAndTrue(a, b, world_from_b, motion, uniform(random, 0.0, 0.01)) ? 1 : 0;
  }
  EXPECT_GT(proven, count / 5);
  EXPECT_LT(proven, count * 4 / 5);
}

/// A field of 0.4 m slides 1 cm over another and turns about one of its edges. Nodes near the edge
/// keep their height, those at the other end do not.
TEST(ClearanceLaws, aFieldThatTilts_isAsNearAsItsFarEnd) {
  Random random(kSeed);
  const MeshTree flat(hillyField(0.0, random));
  for (const double side : {-1.0, 1.0}) {
    const Pose world_from_b{Eigen::Matrix3d::Identity(), Eigen::Vector3d(0.0, 0.0, 0.01)};
    const auto is_proven = [&](double turn) {
      return isProvenAndTrue(flat, flat, world_from_b,
                             {Eigen::Vector3d(0.2 * side, 0.0, 0.01),
                              Eigen::Vector3d(0.0, 0.1, 0.0), Eigen::Vector3d(0.0, turn, 0.0)},
                             0.0);
    };
    EXPECT_TRUE(is_proven(0.023)) << "0.4 m * 0.023, and it deviates by up to 0.3 mm";
    EXPECT_FALSE(is_proven(0.026));
  }
}

/// Convex geometries are as far apart as told at all times, and it tells no much smaller distance.
TEST(ClearanceLaws, convexGeometries_stayAsFarApartAsTold) {
  Random random(kSeed + 2);
  const auto workspace = std::make_unique<ConvexWorkspace>();
  int told = 0;
  double share = 0.0;
  const int count = caseCount(2000);
  for (int i = 0; i < count; ++i) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed + 2 << ", case " << i);
    const ConvexGeometry a = randomGeometry(random);
    const ConvexGeometry b = randomGeometry(random);
    const Pose world_from_a;
    const Pose world_from_b = randomPose(random, 0.6);
    const double size = uniform(random, 0.0, 0.3);
    const Motion motion{world_from_b.translation, size * randomPoint(random, 1.0),
                        size * randomPoint(random, 1.0)};
    const auto distance_at = [&](double time) {
      ConvexWarmStart warm;
      ConvexSearch search{*workspace, warm};
      return signedDistanceBetween(a, world_from_a, b, motion.at(time, world_from_b), search)
          .measured.distance;
    };
    ConvexWarmStart warm;
    ConvexSearch search{*workspace, warm};
    const double clearance =
        clearanceOf({a, world_from_a}, {b, world_from_b}, motion.linear(0.6), search);
    double least = distance_at(-1.0);
    for (int k = -9; k <= 10; ++k) {
      least = std::min(least, distance_at(0.1 * k));
    }
    if (clearance > 0.0) {
      ASSERT_GE(least, clearance - 1e-9);
      ++told;
      share += clearance / least;
    }
  }
  EXPECT_GT(told, count / 4);
  EXPECT_GT(share / told, 0.7) << "of the least distance, in the mean";
}

/// A door beside its post: the gap at the hinge stays, though the far end of the door moves.
TEST(ClearanceLaws, aHingedBox_staysApartAtItsHinge) {
  const auto workspace = std::make_unique<ConvexWorkspace>();
  ConvexWarmStart warm;
  ConvexSearch search{*workspace, warm};
  const Pose post;
  const Pose door{Eigen::Matrix3d::Identity(), Eigen::Vector3d(0.511, 0.0, 0.0)};
  const Motion motion{Eigen::Vector3d(0.011, 0.0, 0.0), Eigen::Vector3d::Zero(),
                      Eigen::Vector3d(0.0, 0.0, 0.02)};
  const double clearance = clearanceOf({Box{{0.01, 0.01, 1.0}}, post},
                                       {Box{{0.5, 0.01, 1.0}}, door}, motion.linear(0.0), search);
  EXPECT_NEAR(clearance, 0.001 - 0.02 * 0.01, 1e-12) << "the far end moves by 2 cm";
}

TEST(ClearanceLaws, aBoxOverAFloor_isSeenFromTheFloor) {
  const auto workspace = std::make_unique<ConvexWorkspace>();
  ConvexWarmStart warm;
  ConvexSearch search{*workspace, warm};
  const Pose floor{Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()).toRotationMatrix(),
                   Eigen::Vector3d(0.4, -2.0, 7.0)};
  const Pose box = floor * Pose{Eigen::Matrix3d::Identity(), Eigen::Vector3d(3.0, 4.0, 0.3)};
  const Motion motion{box.translation, floor.rotation * Eigen::Vector3d(9.0, 9.0, 0.04),
                      floor.rotation * Eigen::Vector3d(0.0, 0.02, 0.0)};
  const ConvexGeometry geometry = Box{{0.5, 0.1, 0.2}};
  const PlacedConvex over{geometry, box};
  EXPECT_NEAR(clearanceOf({HalfSpace(), floor}, over, motion.linear(0.0), search),
              0.1 - 0.04 - 0.02 * 0.5, 1e-12);
  EXPECT_EQ(clearanceOf(over, {HalfSpace(), floor}, motion.linear(0.0), search),
            -std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace collision_monitor::test
