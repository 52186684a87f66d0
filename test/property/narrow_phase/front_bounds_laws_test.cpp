// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "collision_monitor/geometry/ids.h"
#include "narrow_phase/mesh/mesh_distance.h"
#include "narrow_phase/mesh_front/front_entries.h"
#include "support/fixed_seed.h"
#include "support/own_front.h"
#include "support/query_meshes.h"
#include "support/random_poses.h"
#include "support/sample_meshes.h"

// What a front keeps is as far away as it says, however often it was only loosened.
namespace collision_monitor::test::front_bounds_laws {
namespace {

void collect(const MeshTree& tree, std::uint32_t child, std::vector<std::uint32_t>& triangles) {
  if (child == kNone) {
    return;
  }
  if (isTriangle(child)) {
    triangles.push_back(triangleAt(child));
    return;
  }
  for (const std::uint32_t below : tree.nodes()[child].child) {
    collect(tree, below, triangles);
  }
}

/// Triangles that an entry means of one of its two sides.
std::vector<std::uint32_t> meantOf(const MeshTree& tree, Slot slot, std::uint32_t children) {
  std::vector<std::uint32_t> triangles;
  const std::uint32_t child = childOf(tree, slot);
  if (isTriangle(child) || children == 0) {
    collect(tree, child, triangles);
    return triangles;
  }
  for (std::uint32_t i = 0; i < MeshTreeNode::kWidth; ++i) {
    if ((children >> i & 1U) != 0) {
      collect(tree, tree.nodes()[child].child[i], triangles);
    }
  }
  return triangles;
}

double distanceOf(const MeshPair& pair, const FrontEntry& entry) {
  std::uint32_t of_a = 0;
  std::uint32_t of_b = 0;
  if (!isTriangle(childOf(pair.a, entry.pair.a)) || !isTriangle(childOf(pair.b, entry.pair.b))) {
    OpenedPair opened;
    choose(pair, entry.pair.a, entry.pair.b, opened);
    (opened.is_of_a ? of_a : of_b) = entry.children;
  }
  double least = std::numeric_limits<double>::infinity();
  for (const std::uint32_t a : meantOf(pair.a, entry.pair.a, of_a)) {
    for (const std::uint32_t b : meantOf(pair.b, entry.pair.b, of_b)) {
      const PointPair found = nearestPoints(pair.a.triangles()[a], triangleOfB(pair, b));
      least = std::min(least, std::sqrt(found.squared_distance));
    }
  }
  return least;
}

/// About an axis through the middle, along it, or anywhere.
Pose stepFrom(const Pose& pose, Random& random) {
  const double size = std::pow(10.0, uniform(random, -5.0, -2.0));
  const Eigen::Vector3d axis = randomPoint(random, 1.0).normalized();
  const Pose turn{Eigen::AngleAxisd(size, axis).toRotationMatrix(), Eigen::Vector3d::Zero()};
  switch (random() % 3) {
    case 0:
      return turn * pose;
    case 1:
      return pose * turn;
    default:
      return {pose.rotation, pose.translation + size * axis};
  }
}

TEST(FrontBounds, ofEveryKeptPair_areNoLargerThanItsDistance) {
  Random random(kSeed);
  std::vector<MeshTree> trees;
  trees.emplace_back(bumpyMesh(0.3, 8), true);
  trees.emplace_back(sphereMesh(0.35, 8), false);
  trees.emplace_back(triangleSoup(0.5, 60, random), false);
  const auto memory = std::make_unique<MeshQueryMemory>();
  MeshQueryLimits only_loosen;
  only_loosen.visit_budget = 0;
  int with_direction = 0;
  for (int walk = 0; walk < 40; ++walk) {
    const MeshTree& a = trees[random() % trees.size()];
    const MeshTree& b = trees[random() % trees.size()];
    const auto front = std::make_unique<OwnFront>();
    const Pose world_from_a = randomPose(random, 1.0);
    Pose world_from_b = world_from_a * randomPose(random, walk % 2 == 0 ? 0.02 : 0.8);
    for (int step = 0; step < 60; ++step) {
      world_from_b = stepFrom(world_from_b, random);
      distanceBetween({a, world_from_a}, {b, world_from_b}, *memory, *front,
                      step % 6 == 0 ? MeshQueryLimits{} : only_loosen);
      const MeshPair pair = makeMeshPair({a, world_from_a}, {b, world_from_b});
      for (int look = 0; look < 8 && front->size > 0; ++look) {
        const FrontEntry entry =
            entryAt(static_cast<std::uint32_t>(random() % front->size), *front);
        ASSERT_LE(entry.bound, distanceOf(pair, entry) + 1e-12) << walk << ' ' << step;
        with_direction += entry.direction != 0 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(with_direction, 1000);
}

}  // namespace
}  // namespace collision_monitor::test::front_bounds_laws
