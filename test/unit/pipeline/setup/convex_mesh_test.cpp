// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/setup/convex_mesh.h"

#include <gtest/gtest.h>

#include "support/robots/geometry_setup.h"
#include "support/sample_meshes.h"

namespace collision_monitor {
namespace {

bool isConvex(const TriangleMesh& mesh) { return isSurfaceOf(mesh, ConvexHull(mesh.vertices)); }

TEST(ConvexMesh, boxPrismAndSphere_areTheirHulls) {
  EXPECT_TRUE(isConvex(test::boxMesh({0.1, 0.2, 0.3})));
  EXPECT_TRUE(isConvex(test::prismMesh(0.1, 0.2, 12)));
  EXPECT_TRUE(isConvex(test::sphereMesh(0.1, 12)));
}

TEST(ConvexMesh, angle_isNot) { EXPECT_FALSE(isConvex(test::angleMesh())); }

TEST(ConvexMesh, dent_countsFromTheToleranceOn) {
  // A face of a box, divided at its middle, which is pushed in.
  for (const auto& [depth, is_convex] : {std::pair{1e-9, true}, std::pair{1e-6, false}}) {
    TriangleMesh mesh = test::boxMesh({0.5, 0.5, 0.5});
    const auto split = mesh.triangles.back();
    mesh.triangles.pop_back();
    const Eigen::Vector3d middle =
        (mesh.vertices[split[0]] + mesh.vertices[split[1]] + mesh.vertices[split[2]]) / 3.0;
    mesh.vertices.emplace_back(middle * (1.0 - depth));
    const auto center = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
    for (std::size_t i = 0; i < 3; ++i) {
      mesh.triangles.push_back({split[i], split[(i + 1) % 3], center});
    }
    EXPECT_EQ(isConvex(mesh), is_convex) << depth;
  }
}

TEST(ConvexMesh, flatMesh_hasNoVolumeToBound) {
  EXPECT_FALSE(isConvex(test::boxMesh({0.1, 0.2, 0.0})));
}

}  // namespace
}  // namespace collision_monitor
