// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "collision_monitor/fitting/inner_shape.h"
#include "fitting/sphere_trees/build_sphere_tree.h"
#include "support/robots/file_loader.h"

namespace collision_monitor {
namespace {

/// What is outside of all spheres, over vertices and centroids of every triangle. [m]
double farthestOutside(const TriangleMesh& mesh, const std::vector<SphereNode>& spheres) {
  double farthest = -1.0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& t = mesh.triangles[i];
    const Eigen::Vector3d& corner = mesh.vertices[t[i % 3]];
    const Eigen::Vector3d centroid =
        (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0;
    for (const Eigen::Vector3d& point : {corner, centroid}) {
      double nearest = 1e300;
      for (const auto& sphere : spheres) {
        nearest = std::min(nearest, (point - sphere.center).norm() - sphere.radius);
      }
      farthest = std::max(farthest, nearest);
    }
  }
  return farthest;
}

struct Counts {
  int meshes{0};
  int with_inner{0};
};

void check(const TriangleMesh& mesh, const std::string& name, Counts& counts) {
  ++counts.meshes;
  SphereTreeLimits limits;
  limits.max_leaves = 32;
  const SphereTree tree = buildSphereTree(mesh, limits);
  EXPECT_LE(farthestOutside(mesh, spheresOfLevel(tree, 99)), 1e-15) << name;
  EXPECT_LE(farthestOutside(mesh, spheresOfLevel(tree, 2)), 1e-15) << name;
  const InnerShapes inner = inscribeShapes(mesh);
  EXPECT_EQ(inner.sphere.has_value(), inner.capsule.has_value()) << name;
  if (!inner.sphere) {
    return;
  }
  ++counts.with_inner;
  for (const auto& fit : {*inner.sphere, *inner.capsule}) {
    const Pose body_from_geometry = inverse(fit.geometry_from_body);
    for (const auto& vertex : mesh.vertices) {
      // Vertices of edges that others hold may have no triangle.
      EXPECT_GT(signedDistanceTo(fit.shape, body_from_geometry * vertex), -1e-12) << name;
    }
  }
}

TEST(RobotMeshes, everySphereHierarchyEncloses_andEveryInnerShapeIsInside) {
  if (!test::sharedDataDir()) {
    GTEST_SKIP() << test::kNoSharedData;
  }
  Counts counts;
  test::forAllMeshes(
      [&](const TriangleMesh& mesh, const std::string& name) { check(mesh, name, counts); });
  RecordProperty("meshes", counts.meshes);
  RecordProperty("with_inner_shapes", counts.with_inner);
  EXPECT_GT(counts.meshes, 50);
  EXPECT_GT(counts.with_inner, 10);
}

}  // namespace
}  // namespace collision_monitor
