// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "collision_monitor/fitting/enclose.h"
#include "collision_monitor/model/urdf_reader.h"
#include "support/extended_distance.h"
#include "support/file_loader.h"

namespace collision_monitor {
namespace {

/// Every mesh of every robot there is: read as the node reads it, fitted, and each vertex looked at
/// in extended precision.
TEST(RobotMeshes, everyVertexIsInside_andNoProofAsksForANanometre) {
  if (!test::sharedDataDir()) {
    GTEST_SKIP() << test::kNoSharedData;
  }
  std::size_t meshes = 0;
  for (const auto& robot : test::allRobotFiles()) {
    SetupReport report;
    const RobotModel model =
        readRobots({test::describe(robot)}, test::fileLoader(robot.package_root), report);
    for (const auto& link : model.links) {
      for (const auto& element : link.collisions) {
        const auto* mesh = std::get_if<TriangleMesh>(&element.geometry);
        if (mesh == nullptr || mesh->vertices.empty()) {
          continue;
        }
        ++meshes;
        const Enclosure enclosure = encloseTightly(*mesh);
        long double outside = -1.0L;
        for (const auto& vertex : mesh->vertices) {
          outside = std::max(outside, test::extendedDistance(enclosure.shape,
                                                             enclosure.geometry_from_body, vertex));
        }
        EXPECT_LE(outside, 0.0L) << robot.name << " " << link.name;
        EXPECT_LT(enclosure.widening, 1e-9) << robot.name << " " << link.name;
        EXPECT_LE(enclosure.overshoot.mean, enclosure.overshoot.max) << robot.name;
      }
    }
  }
  EXPECT_GT(meshes, 50u);
}

}  // namespace
}  // namespace collision_monitor
