// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "collision_monitor/fitting/fit_parts.h"
#include "support/sample_meshes.h"

// Laws of fits with several shapes.

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

/// A tube that is bent at random: concave, and no plane of symmetry.
TriangleMesh bentTube(unsigned seed) {
  TriangleMesh mesh = test::prismMesh(0.05, 0.3, 12);
  const auto bends = test::randomCloud({0.2, 0.2, 0.2}, 4, seed).vertices;
  for (auto& vertex : mesh.vertices) {
    const double t = vertex.z() / 0.3;
    vertex += t * t * bends[0] + t * t * t * bends[1];
  }
  return mesh;
}

/// How far a point is outside the union, reckoned anew.
double outsideOf(const Fit& fit, const Vector3d& point) {
  double least = 1e9;
  for (const auto& enclosure : fit.shapes) {
    least = std::min(
        least, signedDistanceTo(enclosure.shape, inverse(enclosure.geometry_from_body) * point));
  }
  return least;
}

// A fit takes a tenth of a second, so a dozen meshes have to do; nothing in a seed could be shrunk.
constexpr unsigned kMeshes = 12;

TEST(FitGeometriesLaws, theUnionHoldsEveryPointOfEveryTriangle) {
  constexpr int kSteps = 6;
  for (unsigned seed = 1; seed <= kMeshes; ++seed) {
    const TriangleMesh mesh = bentTube(seed);
    FitLimits limits;
    limits.max_shapes = 1 + seed % 6;
    const Fit fit = fitGeometries({mesh}, limits).front();
    EXPECT_LE(provenExcess(mesh, fit), 0.0) << "seed " << seed;
    EXPECT_LE(fit.shapes.size(), limits.max_shapes) << "seed " << seed;
    double farthest = -1.0;
    for (const auto& t : mesh.triangles) {
      for (int i = 0; i <= kSteps; ++i) {
        for (int j = 0; j <= kSteps - i; ++j) {
          const Vector3d point = (mesh.vertices[t[0]] * i + mesh.vertices[t[1]] * j +
                                  mesh.vertices[t[2]] * (kSteps - i - j)) /
                                 kSteps;
          farthest = std::max(farthest, outsideOf(fit, point));
        }
      }
    }
    EXPECT_LE(farthest, 1e-12) << "seed " << seed;
  }
}

TEST(FitGeometriesLaws, moreShapes_areNeverCoarser) {
  for (unsigned seed = 1; seed <= kMeshes; ++seed) {
    double before = 1e9;
    for (const std::uint32_t count : {1u, 2u, 4u}) {
      FitLimits limits;
      limits.max_shapes = count;
      const Overshoot overshoot = fitGeometries({bentTube(seed)}, limits).front().overshoot;
      const double coarseness = overshoot.max + overshoot.fourth_power_mean;
      EXPECT_LE(coarseness, before) << "seed " << seed << ", " << count << " shapes";
      before = coarseness;
    }
  }
}

}  // namespace
}  // namespace collision_monitor
