// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/geometry/triangle_bvh.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <stdexcept>

#include "collision_monitor/geometry/point_triangle.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

TriangleMesh randomSoup(std::size_t count, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Vector3d centre(place(generator), place(generator), place(generator));
    for (int k = 0; k < 3; ++k) {
      mesh.vertices.emplace_back(
          centre + 0.1 * Vector3d(place(generator), place(generator), place(generator)));
    }
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

TEST(TriangleBvh, oneTriangle_givesItsNearestPoint) {
  const TriangleBvh bvh({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  const NearestPoint nearest = bvh.nearestTo({0.2, 0.2, 0.5});
  EXPECT_NEAR(nearest.distance, 0.5, 1e-15);
  EXPECT_TRUE(nearest.point.isApprox(Vector3d(0.2, 0.2, 0.0), 1e-14));
}

TEST(TriangleBvh, randomSoup_agreesWithEveryTriangleTried) {
  const unsigned seed = 11;
  const TriangleMesh mesh = randomSoup(500, seed);
  const TriangleBvh bvh(mesh);
  std::mt19937 generator(seed + 1);
  std::uniform_real_distribution<double> place(-2.0, 2.0);
  for (int i = 0; i < 300; ++i) {
    const Vector3d point(place(generator), place(generator), place(generator));
    double least = std::numeric_limits<double>::infinity();
    for (const auto& t : mesh.triangles) {
      const Vector3d closest = closestPointOnTriangle(point, mesh.vertices[t[0]],
                                                      mesh.vertices[t[1]], mesh.vertices[t[2]]);
      least = std::min(least, (closest - point).norm());
    }
    EXPECT_DOUBLE_EQ(bvh.nearestTo(point).distance, least) << "seed " << seed << " query " << i;
  }
}

TEST(TriangleBvh, start_changesNothingButIsKeptWhenNearer) {
  const TriangleBvh bvh(randomSoup(200, 5));
  const Vector3d point(1.5, 0.3, -0.2);
  const NearestPoint nearest = bvh.nearestTo(point);
  for (std::uint32_t i = 0; i < bvh.triangles().size(); i += 17) {
    EXPECT_EQ(bvh.nearestTo(point, bvh.nearestOn(i, point)).distance, nearest.distance);
  }
  NearestPoint nearer;
  nearer.distance = 0.5 * nearest.distance;
  EXPECT_EQ(bvh.nearestTo(point, nearer).leaf_triangle, NearestPoint::kNone);
}

TEST(TriangleBvh, meshWithoutTriangles_isItsVertices) {
  const TriangleBvh bvh({{{0, 0, 0}, {5, 0, 0}}, {}});
  EXPECT_DOUBLE_EQ(bvh.nearestTo({4, 3, 0}).distance, std::sqrt(10.0));
}

TEST(TriangleBvh, everyNodeHoldsItsTriangles) {
  const TriangleBvh bvh(randomSoup(333, 9));
  std::size_t in_leaves = 0;
  for (const auto& node : bvh.nodes()) {
    in_leaves += node.count;
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      for (const auto& corner : bvh.triangles()[i]) {
        EXPECT_EQ(squaredDistance(node.bounds, corner), 0.0);
      }
    }
  }
  EXPECT_EQ(in_leaves, 333u);
}

TEST(TriangleBvh, badInput_isAnErrorThatNamesThePlace) {
  EXPECT_THROW(TriangleBvh(TriangleMesh{}), std::invalid_argument);
  TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 7}}};
  try {
    const TriangleBvh bvh(mesh);
    FAIL() << "no error";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "mesh: triangle 0 names vertex 7; there are 3, counted from 0");
  }
  mesh.triangles[0][2] = 2;
  mesh.vertices[1].z() = std::numeric_limits<double>::infinity();
  EXPECT_THROW(TriangleBvh{mesh}, std::invalid_argument);
}

}  // namespace
}  // namespace collision_monitor
