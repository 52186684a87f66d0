// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/sphere_trees/build_sphere_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "collision_monitor/fitting/overshoot.h"
#include "collision_monitor/geometry/ids.h"
#include "support/sample_meshes.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;
using test::boxMesh;

SphereTreeLimits leaves(std::size_t count) {
  SphereTreeLimits limits;
  limits.max_leaves = count;
  return limits;
}

TEST(BuildSphereTree, oneLeafAboutACube_isItsCircumscribedSphere) {
  const SphereTree tree = buildSphereTree(boxMesh({1, 1, 1}), leaves(1));
  ASSERT_EQ(tree.nodes.size(), 1u);
  EXPECT_NEAR(tree.nodes[0].radius, std::sqrt(3.0), 1e-12);
  EXPECT_GE(tree.nodes[0].radius, std::sqrt(3.0));
  EXPECT_LT(tree.nodes[0].center.norm(), 1e-12);
  EXPECT_EQ(tree.nodes[0].child_count, 0u);
}

TEST(BuildSphereTree, longBox_isCutInTheMiddleAndSoAreItsTriangles) {
  // Halves of 2 x 1 x 1: half diagonal sqrt(1 + 1/4 + 1/4). Whole triangles would need 2.12.
  const SphereTree tree = buildSphereTree(boxMesh({2, 0.5, 0.5}), leaves(2));
  ASSERT_EQ(tree.nodes.size(), 3u);
  EXPECT_EQ(tree.nodes[0].first_child, 1u);
  EXPECT_EQ(tree.nodes[0].child_count, 2u);
  for (const int i : {1, 2}) {
    const SphereNode& child = tree.nodes[static_cast<std::size_t>(i)];
    EXPECT_NEAR(child.radius, std::sqrt(1.5), 1e-12);
    EXPECT_NEAR(std::abs(child.center.x()), 1.0, 1e-12);
    EXPECT_EQ(child.level, 1u);
  }
  EXPECT_LT(tree.nodes[1].center.x(), tree.nodes[2].center.x());
}

TEST(BuildSphereTree, oneTriangle_fourLeaves_areItsFourPieces) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {4, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  const SphereTree tree = buildSphereTree(mesh, leaves(2));
  // Below x = 2 a trapezium with corners (0,0), (2,0), (2,.5), (0,1): its diagonal (2,0)-(0,1) is
  // the diameter of the least circle. Above a triangle with the hypotenuse (2,.5)-(4,0).
  ASSERT_EQ(tree.nodes.size(), 3u);
  EXPECT_NEAR(tree.nodes[1].radius, std::sqrt(5.0) / 2, 1e-12);
  EXPECT_NEAR(tree.nodes[2].radius, std::sqrt(4.25) / 2, 1e-12);
  EXPECT_EQ(tree.nodes[1].center.z(), 0.0);
}

TEST(BuildSphereTree, nodesAreBreadthFirst_withChildrenSideBySide) {
  const SphereTree tree = buildSphereTree(test::prismMesh(0.1, 0.5, 20), leaves(30));
  EXPECT_EQ(spheresOfLevel(tree, 99).size(), 30u);
  std::size_t next_child = 1;
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const SphereNode& node = tree.nodes[i];
    EXPECT_TRUE(i == 0 || node.level >= tree.nodes[i - 1].level);
    if (node.child_count > 0) {
      EXPECT_EQ(node.first_child, next_child);
      EXPECT_EQ(tree.nodes[node.first_child].level, node.level + 1);
      next_child += node.child_count;
    }
  }
  EXPECT_EQ(next_child, tree.nodes.size());
}

TEST(BuildSphereTree, limits_areKept) {
  SphereTreeLimits limits = leaves(100000);
  limits.min_radius = 0.1;
  const SphereTree tree = buildSphereTree(boxMesh({0.5, 0.5, 0.5}), limits);
  for (const auto& node : tree.nodes) {
    EXPECT_EQ(node.child_count == 0, node.radius <= 0.1);
  }
  limits = leaves(100000);
  limits.min_overshoot = 0.1;
  for (const auto& node : buildSphereTree(boxMesh({0.5, 0.5, 0.5}), limits).nodes) {
    EXPECT_EQ(node.child_count == 0, node.overshoot <= 0.1);
  }
  limits = leaves(100000);
  limits.max_level = 3;
  EXPECT_EQ(spheresOfLevel(buildSphereTree(boxMesh({1, 1, 1}), limits), 99).size(), 8u);
}

TEST(BuildSphereTree, primitives) {
  const SphereTree sphere = buildSphereTree(Sphere{0.3}, leaves(64));
  ASSERT_EQ(sphere.nodes.size(), 1u);
  EXPECT_EQ(sphere.nodes[0].radius, 0.3);
  EXPECT_EQ(sphere.nodes[0].overshoot, 0.0);
  const double box = buildSphereTree(Box{{1, 2, 3}}, leaves(1)).nodes[0].radius;
  EXPECT_NEAR(box, std::sqrt(14.0), 1e-12);
  const double cylinder = buildSphereTree(Cylinder{1.0, 0.5}, leaves(1)).nodes[0].radius;
  EXPECT_GE(cylinder, std::hypot(1.0, 0.5));
  EXPECT_LT(cylinder, std::hypot(1.0, 0.5) * 1.01);
  const double capsule = buildSphereTree(Capsule{1.0, 0.5}, leaves(1)).nodes[0].radius;
  EXPECT_GE(capsule, 1.5);
  EXPECT_LT(capsule, 1.5 * 1.01);
}

TEST(BuildSphereTree, flatPointLikeAndLooseGeometry_isEnclosed) {
  TriangleMesh point;
  point.vertices = {{1, 2, 3}};
  const SphereTree tree = buildSphereTree(point, leaves(8));
  ASSERT_EQ(tree.nodes.size(), 1u);
  EXPECT_EQ(tree.nodes[0].center, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(tree.nodes[0].radius, 0.0);
  // A vertex of no triangle, far from the only one.
  TriangleMesh loose;
  loose.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 0, 0}};
  loose.triangles = {{0, 1, 2}};
  const auto spheres = spheresOfLevel(buildSphereTree(loose, leaves(2)), 1);
  EXPECT_NEAR(spheres[1].center.x(), 9.0, 1e-12);
  EXPECT_GT(buildSphereTree(boxMesh({1, 1, 0}), leaves(64)).nodes.size(), 64u);
  EXPECT_EQ(buildSphereTree(Box{{0, 0, 0}}, leaves(64)).nodes.size(), 1u);
}

bool isHeldByAnother(const Vector3d& point, std::size_t own,
                     const std::vector<SphereNode>& spheres) {
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const double radius = spheres[i].radius;
    if (i != own && (point - spheres[i].center).squaredNorm() < radius * radius) {
      return true;
    }
  }
  return false;
}

/// How far the union of spheres reaches beyond the surface: at points of the spheres that no other
/// sphere holds, `count` a sphere.
Overshoot overshootOf(const std::vector<SphereNode>& spheres, const TriangleBvh& mesh, int count) {
  Overshoot overshoot;
  double total_area = 0.0;
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const auto samples = sampleSurface(Sphere{spheres[i].radius}, count);
    NearestPoint nearest;
    for (const auto& sample : samples) {
      const Eigen::Vector3d point = spheres[i].center + sample.point;
      if (isHeldByAnother(point, i, spheres)) {
        continue;
      }
      const NearestPoint start = nearest.leaf_triangle == kNone
                                     ? NearestPoint{}
                                     : mesh.nearestOn(nearest.leaf_triangle, point);
      nearest = mesh.nearestTo(point, start, 0.1);
      overshoot.max = std::max(overshoot.max, nearest.distance);
      overshoot.mean += sample.area * nearest.distance;
      total_area += sample.area;
    }
  }
  overshoot.mean = total_area > 0.0 ? overshoot.mean / total_area : overshoot.max;
  return overshoot;
}

TEST(BuildSphereTree, scale_changesNothingButTheScale) {
  const TriangleMesh mesh = test::prismMesh(0.2, 0.5, 24);
  const SphereTree tree = buildSphereTree(mesh, leaves(32));
  for (const double scale : {1e-6, 1e6}) {
    const SphereTree other = buildSphereTree(test::scaled(mesh, scale), leaves(32));
    EXPECT_NEAR(other.nodes[0].radius, tree.nodes[0].radius * scale, 1e-12 * scale);
    EXPECT_EQ(spheresOfLevel(other, 99).size(), 32u);
    EXPECT_NEAR(
        overshootOf(spheresOfLevel(other, 99), TriangleBvh(test::scaled(mesh, scale)), 100).mean,
        scale * overshootOf(spheresOfLevel(tree, 99), TriangleBvh(mesh), 100).mean,
        0.2 * scale * tree.nodes[0].radius);
  }
}

TEST(BuildSphereTree, moreLeaves_reachLessFarBeyondTheSurface) {
  // A sheet: inside a solid, spheres about its surface count as far from it too.
  const TriangleMesh mesh = boxMesh({1.0, 0.2, 0.0});
  const TriangleBvh bvh(mesh);
  const auto maxOvershoot = [&](std::size_t count) {
    return overshootOf(spheresOfLevel(buildSphereTree(mesh, leaves(count)), 99), bvh, 200).max;
  };
  EXPECT_GT(maxOvershoot(1), 3.0 * maxOvershoot(8));
  EXPECT_GT(maxOvershoot(8), 3.0 * maxOvershoot(128));
}

std::string faultOf(const Geometry& geometry, const SphereTreeLimits& limits) {
  try {
    buildSphereTree(geometry, limits);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(BuildSphereTree, badInput_isNamed) {
  TriangleMesh mesh = boxMesh({1, 1, 1});
  mesh.vertices[3].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(faultOf(mesh, {}).find("vertex 3"), std::string::npos);
  mesh = boxMesh({1, 1, 1});
  mesh.triangles[5][1] = 8;
  EXPECT_NE(faultOf(mesh, {}).find("triangle 5 names vertex 8"), std::string::npos);
  EXPECT_NE(faultOf(TriangleMesh{}, {}).find("no vertices"), std::string::npos);
  EXPECT_NE(faultOf(Cylinder{-1.0, 1.0}, {}).find("cylinder half length is -1"), std::string::npos);
  EXPECT_NE(faultOf(Box{{1, 1, 1e101}}, {}).find("along z"), std::string::npos);
  EXPECT_NE(faultOf(Sphere{1.0}, leaves(0)).find("max_leaves"), std::string::npos);
}

TEST(BuildSphereTree, aMillionTriangles_areNoTrouble) {
  const TriangleMesh mesh = test::sphereMesh(1.0, 1000);
  ASSERT_EQ(mesh.triangles.size(), 1000000u);
  const SphereTree tree = buildSphereTree(mesh, leaves(4));
  EXPECT_NEAR(tree.nodes[0].radius, 1.0, 1e-6);
  EXPECT_EQ(spheresOfLevel(tree, 99).size(), 4u);
}

}  // namespace
}  // namespace collision_monitor
