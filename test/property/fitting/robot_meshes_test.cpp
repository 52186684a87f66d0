// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "collision_monitor/fitting/enclose.h"
#include "support/reference/extended_distance.h"
#include "support/robots/file_loader.h"

namespace collision_monitor {
namespace {

/// Every mesh of every robot there is: read as the node reads it, fitted, and each vertex looked at
/// in extended precision.
TEST(RobotMeshes, everyVertexIsInside_andNoProofAsksForANanometre) {
  if (!test::sharedDataDir()) {
    GTEST_SKIP() << test::kNoSharedData;
  }
  std::size_t meshes = 0;
  test::forAllMeshes([&](const TriangleMesh& mesh, const std::string& name) {
    ++meshes;
    const Enclosure enclosure = encloseTightly(mesh);
    long double outside = -1.0L;
    for (const auto& vertex : mesh.vertices) {
      outside = std::max(
          outside, test::extendedDistance(enclosure.shape, enclosure.geometry_from_body, vertex));
    }
    EXPECT_LE(outside, 0.0L) << name;
    EXPECT_LT(enclosure.widening, 1e-9) << name;
    EXPECT_LE(enclosure.overshoot.mean, enclosure.overshoot.max) << name;
  });
  EXPECT_GT(meshes, 50u);
}

}  // namespace
}  // namespace collision_monitor
