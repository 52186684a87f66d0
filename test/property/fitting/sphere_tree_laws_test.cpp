// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "collision_monitor/fitting/enclose.h"
#include "collision_monitor/fitting/inner_shape.h"
#include "fitting/sphere_trees/build_sphere_tree.h"
#include "geometry/hulls/convex_hull.h"
#include "support/fixed_seed.h"
#include "support/reference/extended_distance.h"
#include "support/sample_meshes.h"

namespace collision_monitor::sphere_tree_laws {
namespace {

using LongVector = Eigen::Matrix<long double, 3, 1>;

double between(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1000001) * 1e-6;
}

Eigen::Vector3d vector(double reach) {
  return {between(-reach, reach), between(-reach, reach), between(-reach, reach)};
}

/// From needles to blobs, also flat; triangles that cross each other; anywhere within 10 m.
TriangleMesh anySoup() {
  const Eigen::Vector3d half_extents(between(0.0, 0.5), between(0.0, 0.5), between(0.001, 0.5));
  const int count = *rc::gen::inRange(3, 40);
  const auto seed = *rc::gen::inRange(0u, 1000000u);
  return test::moved(test::randomCloud(half_extents, count, seed), vector(3.0), vector(10.0));
}

/// Convex, closed, outward.
TriangleMesh anySolid() {
  const Eigen::Vector3d half_extents(between(0.01, 0.5), between(0.01, 0.5), between(0.01, 0.5));
  const auto seed = *rc::gen::inRange(0u, 1000000u);
  const TriangleMesh cloud = test::randomCloud(half_extents, *rc::gen::inRange(8, 60), seed);
  return convexHullOf(test::moved(cloud, vector(3.0), vector(10.0)).vertices);
}

/// Points all over the triangle, corners and edges included, in extended precision.
std::vector<LongVector> samplesOf(const TriangleMesh& mesh,
                                  const std::array<std::uint32_t, 3>& triangle) {
  constexpr int kSteps = 12;
  std::vector<LongVector> samples;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; i + j <= kSteps; ++j) {
      const long double u = static_cast<long double>(i) / kSteps;
      const long double v = static_cast<long double>(j) / kSteps;
      samples.push_back((1.0L - u - v) * mesh.vertices[triangle[0]].cast<long double>() +
                        u * mesh.vertices[triangle[1]].cast<long double>() +
                        v * mesh.vertices[triangle[2]].cast<long double>());
    }
  }
  return samples;
}

bool isEnclosed(const LongVector& point, const std::vector<SphereNode>& spheres) {
  return std::any_of(spheres.begin(), spheres.end(), [&](const SphereNode& sphere) {
    // The sample itself is rounded, to 1e-19 of its coordinates.
    return (point - sphere.center.cast<long double>()).norm() <= sphere.radius + 1e-17L;
  });
}

RC_GTEST_PROP(SphereTreeLaws, everyLevelEnclosesEveryTriangle, ()) {
  const TriangleMesh mesh = anySoup();
  SphereTreeLimits limits;
  limits.max_leaves = *rc::gen::inRange<std::size_t>(1, 60);
  const SphereTree tree = buildSphereTree(mesh, limits);
  for (std::uint32_t level = 0; level < levelCount(tree); ++level) {
    const auto spheres = spheresOfLevel(tree, level);
    for (const auto& triangle : mesh.triangles) {
      for (const auto& sample : samplesOf(mesh, triangle)) {
        RC_ASSERT(isEnclosed(sample, spheres));
      }
    }
  }
}

RC_GTEST_PROP(SphereTreeLaws, everyCutEncloses_alsoFromAnotherFrame, ()) {
  const TriangleMesh mesh = anySoup();
  Pose link_from_geometry;
  const Eigen::Vector3d turn = vector(3.0);
  link_from_geometry.rotation =
      Eigen::AngleAxisd(turn.norm(), (turn + Eigen::Vector3d(1e-9, 0, 0)).normalized())
          .toRotationMatrix();
  link_from_geometry.translation = vector(5.0);
  const SphereTree tree = placed(buildSphereTree(mesh, {}), link_from_geometry);
  const auto spheres = spheresOfLevel(tree, static_cast<std::uint32_t>(between(0.0, 8.0)));
  for (const auto& triangle : mesh.triangles) {
    for (const auto& sample : samplesOf(mesh, triangle)) {
      const LongVector in_link = link_from_geometry.rotation.cast<long double>() * sample +
                                 link_from_geometry.translation.cast<long double>();
      RC_ASSERT(isEnclosed(in_link, spheres));
    }
  }
}

/// Points on the surface, hardly inside it.
template <class Primitive>
void expectEnclosed(const Primitive& shape) {
  SphereTreeLimits limits;
  limits.max_leaves = 16;
  const auto spheres = spheresOfLevel(buildSphereTree(shape, limits), 99);
  for (const auto& sample : sampleSurface(shape, 300)) {
    RC_ASSERT(isEnclosed(((1.0 - 1e-15) * sample.point).template cast<long double>(), spheres));
  }
}

RC_GTEST_PROP(SphereTreeLaws, primitivesAreEnclosed, ()) {
  expectEnclosed(Box{{between(0, 1), between(0, 1), between(0, 1)}});
  expectEnclosed(Capsule{between(0, 1), between(0, 1)});
  const Cylinder cylinder{between(0, 1), between(0, 1)};
  const auto spheres = spheresOfLevel(buildSphereTree(cylinder, {}), 99);
  for (int i = 0; i < 3600; ++i) {
    const double angle = i * 0.00174532925199433;
    const double share = (i % 7) / 6.0;
    const Eigen::Vector3d wall(cylinder.radius * std::cos(angle), cylinder.radius * std::sin(angle),
                               cylinder.half_length * (2.0 * share - 1.0));
    const Eigen::Vector3d lid(share * wall.x(), share * wall.y(), cylinder.half_length);
    RC_ASSERT(isEnclosed(((1.0 - 1e-15) * wall).cast<long double>(), spheres));
    RC_ASSERT(isEnclosed(((1.0 - 1e-15) * lid).cast<long double>(), spheres));
  }
}

RC_GTEST_PROP(InnerShapeLaws, nothingOfTheSurfaceIsInTheInnerShapes, ()) {
  const TriangleMesh mesh = anySolid();
  const InnerShapes inner = inscribeShapes(mesh);
  RC_ASSERT(inner.sphere.has_value());
  RC_ASSERT(inner.capsule.has_value());
  for (const auto& fit : {*inner.sphere, *inner.capsule}) {
    RC_ASSERT(isRigid(fit.geometry_from_body, 1e-12));
    for (const auto& triangle : mesh.triangles) {
      for (const auto& sample : samplesOf(mesh, triangle)) {
        const Eigen::Vector3d point = sample.cast<double>();
        RC_ASSERT(test::extendedDistance(fit.shape, fit.geometry_from_body, point) > 0.0L);
      }
    }
  }
}

RC_GTEST_PROP(InnerShapeLaws, innerIsInsideOuter, ()) {
  const TriangleMesh mesh = anySolid();
  const InnerShapes inner = inscribeShapes(mesh);
  const Enclosure outer = encloseTightly(mesh);
  for (const auto& fit : {*inner.sphere, *inner.capsule}) {
    RC_ASSERT(volumeOf(fit.shape) <= volumeOf(outer.shape));
    for (const auto& sample : sampleSurface(fit.shape, 200)) {
      const Eigen::Vector3d point = fit.geometry_from_body * sample.point;
      const Pose body_from_geometry = inverse(outer.geometry_from_body);
      RC_ASSERT(signedDistanceTo(outer.shape, body_from_geometry * point) < 1e-12);
    }
  }
}

/// In a convex solid a ball is inside exactly when it is behind every face, so the sphere's center
/// and radius can be checked, and bettered, without any of the code under test.
RC_GTEST_PROP(InnerShapeLaws, noStepInAnyDirectionGivesAMuchLargerSphere, ()) {
  const TriangleMesh mesh = anySolid();
  const PosedShape fit = inscribeShapes(mesh).sphere.value();
  const auto depthAt = [&](const Eigen::Vector3d& point) {
    double depth = 1e300;
    for (const auto& t : mesh.triangles) {
      const Eigen::Vector3d& a = mesh.vertices[t[0]];
      const Eigen::Vector3d normal =
          (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).normalized();
      depth = std::min(depth, normal.dot(a - point));
    }
    return depth;
  };
  const double radius = radiusOf(fit.shape);
  RC_ASSERT(depthAt(fit.geometry_from_body.translation) >= radius);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d step = vector(radius);
    RC_ASSERT(depthAt(fit.geometry_from_body.translation + step) <= 1.02 * radius);
  }
}

}  // namespace
}  // namespace collision_monitor::sphere_tree_laws
