// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/mesh/mesh_hulls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "collision_monitor/geometry/ids.h"
#include "support/expect_distance.h"
#include "support/robots/geometry_setup.h"
#include "support/sample_meshes.h"

namespace collision_monitor::test {
namespace {

/// A mesh and its hull.
struct Hulled {
  explicit Hulled(const TriangleMesh& mesh) : around(ConvexHull(mesh.vertices)), tree(mesh, true) {}

  HeldSurface at(const Pose& world_from_body) const { return {around, &tree, world_from_body}; }

  ConvexGeometry around;
  MeshTree tree;
};

class MeshHulls : public testing::Test {
 protected:
  MeshDistance measure(const HeldSurface& a, const HeldSurface& b,
                       double stop_beyond = std::numeric_limits<double>::infinity()) {
    return distanceByHulls(a, b, {stop_beyond}, *memory_, {warm_, nearest_});
  }

  std::unique_ptr<MeshQueryMemory> memory_ = std::make_unique<MeshQueryMemory>();
  ConvexWarmStart warm_;
  TrianglePair nearest_;
  const Pose origin_{};
  const Hulled cube_{boxMesh({1, 1, 1})};
  // Bars along x and y, 0.3 m long and 0.1 m thick; their hull runs from (0.3, 0.1) to (0.1, 0.3).
  const Hulled angle_{angleMesh()};
  const Hulled small_{boxMesh({0.01, 0.01, 0.01})};
};

TEST_F(MeshHulls, cubes_distancePointsAndTriangles) {
  const Pose pose = at(5, 6, 14);
  const MeshDistance found = measure(cube_.at(origin_), cube_.at(pose));
  EXPECT_EQ(found.state, MeshState::exact);
  expectDistance(found.measured, 13.0, Eigen::Vector3d(3, 4, 12) / 13.0, {1, 1, 1});
  EXPECT_LT(found.nearest.a, 12U);
  EXPECT_LT(found.nearest.b, 12U);
}

TEST_F(MeshHulls, beforeTheEndOfABar_exact) {
  const Pose pose = at(0.41, 0.05, 0.0);
  const MeshDistance found = measure(angle_.at(origin_), small_.at(pose));
  EXPECT_EQ(found.state, MeshState::exact);
  EXPECT_NEAR(found.measured.distance, 0.1, kExact);
  expectNear(found.measured.normal_a_to_b, {1, 0, 0}, "normal");
}

// The cube's corner looks at the middle of the hull's slope, under which the angle is hollow.
TEST_F(MeshHulls, beforeTheHollow_boundedByTheHull) {
  const Pose pose = at(0.31, 0.31, 0.0);
  const MeshDistance found = measure(angle_.at(origin_), small_.at(pose));
  EXPECT_EQ(found.state, MeshState::lower_bound);
  EXPECT_NEAR(found.measured.distance, std::sqrt(0.5) * 0.2, kExact);
}

TEST_F(MeshHulls, solidWithoutMesh_itsRadiusCounts) {
  const ConvexGeometry sphere = Sphere{0.5};
  const Pose pose = at(0, 4, 0);
  const MeshDistance found = measure(cube_.at(origin_), {sphere, nullptr, pose});
  EXPECT_EQ(found.state, MeshState::exact);
  expectDistance(found.measured, 2.5, {0, 1, 0}, {0, 1, 0});
  EXPECT_EQ(found.nearest.b, kNone);
}

TEST_F(MeshHulls, fartherThanAskedFor_boundNotBelow) {
  const Pose pose = at(5, 0.1, 0.2);
  const MeshDistance found = measure(cube_.at(origin_), cube_.at(pose), 1.0);
  EXPECT_EQ(found.state, MeshState::lower_bound);
  EXPECT_GE(found.measured.distance, 1.0);
  EXPECT_LE(found.measured.distance, 3.0 + kExact);
}

TEST_F(MeshHulls, hullsThatMeet_tellNothing) {
  const Pose pose = hookedPose();
  EXPECT_EQ(measure(angle_.at(origin_), angle_.at(pose)).state, MeshState::unknown);
  const Pose touching = at(2, 0, 0);
  EXPECT_EQ(measure(cube_.at(origin_), cube_.at(touching)).state, MeshState::unknown);
  const ConvexGeometry sphere = Sphere{0.5};
  const Pose in_its_radius = at(1.4, 0, 0);
  EXPECT_EQ(measure(cube_.at(origin_), {sphere, nullptr, in_its_radius}).state, MeshState::unknown);
}

TEST_F(MeshHulls, halfSpaceOrPoseNotFinite_tellNothing) {
  const ConvexGeometry ground = HalfSpace{};
  const Pose below = at(0, 0, -5);
  EXPECT_EQ(measure(cube_.at(origin_), {ground, nullptr, below}).state, MeshState::unknown);
  const Pose bad = at(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  EXPECT_EQ(measure(cube_.at(bad), cube_.at(below)).state, MeshState::unknown);
  EXPECT_EQ(measure(cube_.at(below), cube_.at(bad)).state, MeshState::unknown);
}

TEST_F(MeshHulls, farFromTheOrigin_pointsAreStillOnTheMesh) {
  const Pose far = at(1000, 2000, 500);
  const Pose beside = at(1003, 2000.3, 500.1);
  const MeshDistance found = measure(cube_.at(far), cube_.at(beside));
  EXPECT_EQ(found.state, MeshState::exact);
  EXPECT_NEAR(found.measured.distance, 1.0, 1e-9);
}

/// The hull of the angle runs over its hollow; there the surface is up to 0.14 m below it.
TEST_F(MeshHulls, nearestPointsOffTheSurface_countWithinTheTolerance) {
  const Pose pose = at(0.29, 0.29, 0.0);
  const HeldSurface b = small_.at(pose);
  const auto within = [&](double tolerance) {
    return distanceByHulls(angle_.at(origin_), b, {10.0, tolerance}, *memory_, {warm_, nearest_});
  };
  const MeshDistance bound = within(0.0);
  EXPECT_EQ(bound.state, MeshState::lower_bound);
  EXPECT_EQ(within(0.001).state, MeshState::lower_bound);
  const double truth =
      distanceBetween({angle_.tree, origin_}, {small_.tree, pose}, *memory_).measured.distance;
  const MeshDistance found = within(1.0);
  ASSERT_EQ(found.state, MeshState::exact);
  EXPECT_NEAR(found.measured.distance, bound.measured.distance, kExact);
  EXPECT_LE(truth, found.measured.distance + found.shortfall);
  EXPECT_GE(found.measured.distance, 0.5 * truth);
}

/// A flat dent in the top of a plate is below its hull.
TEST_F(MeshHulls, overADent_theShortfallIsItsDepth) {
  constexpr double kDent = 1e-3;
  TriangleMesh plate = boxMesh({0.1, 0.1, 0.01});
  const auto top = static_cast<std::uint32_t>(plate.vertices.size());
  plate.vertices.emplace_back(0.0, 0.0, 0.01 - kDent);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const auto& triangle : plate.triangles) {
    const bool is_top = std::all_of(triangle.begin(), triangle.end(), [&](std::uint32_t corner) {
      return plate.vertices[corner].z() > 0.0;
    });
    if (is_top) {
      for (std::size_t i = 0; i < 3; ++i) {
        triangles.push_back({triangle[i], triangle[(i + 1) % 3], top});
      }
    } else {
      triangles.push_back(triangle);
    }
  }
  plate.triangles = triangles;
  const Hulled dented(plate);
  const Pose pose = at(0.0, 0.0, 0.12);
  const auto within = [&](double tolerance) {
    return distanceByHulls(dented.at(origin_), small_.at(pose), {10.0, tolerance}, *memory_,
                           {warm_, nearest_});
  };
  EXPECT_EQ(within(0.0).state, MeshState::lower_bound);
  EXPECT_EQ(within(1e-5).state, MeshState::lower_bound);
  const MeshDistance found = within(2.0 * kDent);
  EXPECT_EQ(found.state, MeshState::exact);
  EXPECT_NEAR(found.measured.distance, 0.1, kExact);
  EXPECT_GT(found.shortfall, 0.0);
  EXPECT_LE(found.shortfall, kDent + kExact);
}

}  // namespace
}  // namespace collision_monitor::test
