// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/geometry/triangle_bvh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "collision_monitor/geometry/ids.h"
#include "geometry/point_triangle.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

TriangleMesh randomSoup(std::size_t count, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Vector3d center(place(generator), place(generator), place(generator));
    for (int k = 0; k < 3; ++k) {
      mesh.vertices.emplace_back(
          center + 0.1 * Vector3d(place(generator), place(generator), place(generator)));
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
  EXPECT_EQ(bvh.nearestTo(point, nearer).leaf_triangle, kNone);
}

TEST(TriangleBvh, meshWithoutTriangles_isItsVertices) {
  const TriangleBvh bvh({{{0, 0, 0}, {5, 0, 0}}, {}});
  EXPECT_DOUBLE_EQ(bvh.nearestTo({4, 3, 0}).distance, std::sqrt(10.0));
}

/// The largest distance at which a node's boxes miss a corner that is in them; counts the leaves.
double worstMiss(const TriangleBvh& bvh, std::uint32_t id, std::size_t& leaves) {
  const auto& node = bvh.nodes()[id];
  double worst = 0.0;
  for (std::size_t lane = 0; lane < 4; ++lane) {
    const auto l = static_cast<Eigen::Index>(lane);
    if (!std::isfinite(node.low[0][l])) {
      continue;  // no child
    }
    std::vector<std::uint32_t> below{node.child[lane]};
    while (!below.empty()) {
      const std::uint32_t child = below.back();
      below.pop_back();
      if ((child & TriangleBvh::Node::kLeaf) == 0) {
        for (std::size_t i = 0; i < 4; ++i) {
          if (std::isfinite(bvh.nodes()[child].low[0][static_cast<Eigen::Index>(i)])) {
            below.push_back(bvh.nodes()[child].child[i]);
          }
        }
        continue;
      }
      for (const auto& corner : bvh.triangles()[child - TriangleBvh::Node::kLeaf]) {
        const Vector3d unit = (corner - bvh.unitFrame().center) / bvh.unitFrame().scale;
        for (std::size_t k = 0; k < 3; ++k) {
          const double value = unit[static_cast<Eigen::Index>(k)];
          worst = std::max({worst, node.low[k][l] - value, value - node.high[k][l]});
        }
      }
    }
    if ((node.child[lane] & TriangleBvh::Node::kLeaf) != 0) {
      ++leaves;
    } else {
      worst = std::max(worst, worstMiss(bvh, node.child[lane], leaves));
    }
  }
  return worst;
}

TEST(TriangleBvh, everyNodeHoldsItsTriangles) {
  const TriangleBvh bvh(randomSoup(333, 9));
  std::size_t leaves = 0;
  EXPECT_EQ(worstMiss(bvh, 0, leaves), 0.0);
  EXPECT_EQ(leaves, 333u);
}

TEST(TriangleBvh, trianglesInOnePlace_areAllFound) {
  TriangleMesh mesh = randomSoup(1, 3);
  mesh.triangles.assign(1000, mesh.triangles[0]);
  const TriangleBvh bvh(mesh);
  std::size_t leaves = 0;
  EXPECT_EQ(worstMiss(bvh, 0, leaves), 0.0);
  EXPECT_EQ(leaves, 1000u);
}

TEST(TriangleBvh, geometricSizes_stayWithinTheStack) {
  // Each triangle is a tenth of the one before: splits by area take them off one by one.
  TriangleMesh mesh;
  double size = 1.0;
  for (std::uint32_t i = 0; i < 90; ++i, size *= 0.1) {
    mesh.vertices.insert(mesh.vertices.end(), {{size, 0, 0}, {size, size, 0}, {size, 0, size}});
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const TriangleBvh bvh(mesh);
  std::size_t leaves = 0;
  EXPECT_EQ(worstMiss(bvh, 0, leaves), 0.0);
  EXPECT_EQ(leaves, 90u);
  EXPECT_NEAR(bvh.nearestTo({1e-3, 0, 0}).distance, 0.0, 1e-15);
  EXPECT_NEAR(bvh.nearestTo({-1, 0, 0}).distance, 1.0, 1e-14);
}

TEST(TriangleBvh, anySizeAndPlace_givesTheSameDistances) {
  const TriangleMesh soup = randomSoup(300, 21);
  const TriangleBvh bvh(soup);
  const Vector3d query(0.3, 1.4, -0.6);
  const double expected = bvh.nearestTo(query).distance;
  for (const double scale : {1e-160, 1e-30, 1e-6, 1e6, 1e30, 1e99}) {
    TriangleMesh mesh = soup;
    for (auto& vertex : mesh.vertices) {
      vertex *= scale;
    }
    // Below 1e-154 m squares underflow.
    const double tolerance = scale < 1e-150 ? 1e-150 : 1e-12 * scale;
    EXPECT_NEAR(TriangleBvh(mesh).nearestTo(scale * query).distance, scale * expected, tolerance);
  }
  EXPECT_NEAR(bvh.nearestTo({1e90, 0, 0}).distance, 1e90, 1e76);
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
