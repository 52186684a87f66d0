// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/robots/balls_in_a_hollow.h"

#include <vector>

#include "support/robots/geometry_setup.h"
#include "support/robots/hand_made_setup.h"
#include "support/sample_meshes.h"

namespace collision_monitor::test {
namespace {

constexpr std::size_t kBalls = 12;

}  // namespace

CycleSetup ballsInAHollow(std::uint32_t budget) {
  SetupOptions options;
  options.default_limits.max_shapes = 1;
  options.refine.limits.budget = budget;
  std::vector<Geometry> geometries{angleMesh()};
  geometries.insert(geometries.end(), kBalls, Sphere{0.02});
  return geometrySetup(geometries, options);
}

LinkPoses posesInAHollow(const CycleSetup& setup) {
  LinkPoses poses = knownPoses(setup);
  for (std::size_t i = 1; i <= kBalls; ++i) {
    const auto column = static_cast<double>(i % 4);
    const auto row = static_cast<double>(i / 4);
    poses.world_from_link[i].translation = {0.14 + 0.05 * column, 0.14 + 0.05 * row, 0.0};
  }
  return poses;
}

}  // namespace collision_monitor::test
