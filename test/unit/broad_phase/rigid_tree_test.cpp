// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "broad_phase/rigid_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "support/random_poses.h"

namespace collision_monitor::test {
namespace {

Aabb randomBox(Random& random) {
  const Eigen::Vector3d center = randomPoint(random, 1.0);
  const Eigen::Vector3d half = randomPoint(random, 0.1).cwiseAbs();
  return {center - half, center + half};
}

std::vector<Aabb> randomBoxes(std::size_t count, Random& random) {
  std::vector<Aabb> boxes;
  while (boxes.size() < count) {
    boxes.push_back(randomBox(random));
  }
  return boxes;
}

double distanceTo(const Aabb& box, const Eigen::Vector3d& point) {
  return (point - point.cwiseMax(box.min).cwiseMin(box.max)).norm();
}

TEST(RigidTree, boxOfAnySize_visitsEveryBodyThatItMeets) {
  Random random(1);
  for (const std::size_t count : {1U, 2U, 3U, 100U, 1000U}) {
    const std::vector<Aabb> boxes = randomBoxes(count, random);
    const RigidTree tree(boxes);
    for (int i = 0; i < 100; ++i) {
      const Aabb asked = randomBox(random);
      std::vector<bool> is_visited(count, false);
      tree.visitMeeting(smallBoxOf(asked), [&](std::uint32_t body) {
        EXPECT_FALSE(is_visited[body]) << "twice";
        is_visited[body] = true;
      });
      for (std::size_t body = 0; body < count; ++body) {
        EXPECT_EQ(is_visited[body], meets(smallBoxOf(boxes[body]), smallBoxOf(asked)));
      }
    }
  }
}

TEST(RigidTree, pointWithADistanceThatShrinks_visitsTheNearestBody) {
  Random random(2);
  const std::vector<Aabb> boxes = randomBoxes(500, random);
  const RigidTree tree(boxes);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d point = randomPoint(random, 2.0);
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t visits = 0;
    tree.visitNear(point, nearest, [&](std::uint32_t body) {
      nearest = std::min(nearest, distanceTo(boxes[body], point));
      ++visits;
    });
    double expected = std::numeric_limits<double>::infinity();
    for (const Aabb& box : boxes) {
      expected = std::min(expected, distanceTo(box, point));
    }
    EXPECT_EQ(nearest, expected);
    EXPECT_LT(visits, boxes.size());
  }
}

TEST(RigidTree, distanceBelowZero_visitsNothing) {
  const RigidTree tree({{Eigen::Vector3d::Constant(-1.0), Eigen::Vector3d::Constant(1.0)}});
  tree.visitNear(Eigen::Vector3d::Zero(), -0.1, [](std::uint32_t) { FAIL(); });
}

TEST(RigidTree, boxWithoutBounds_isMetByAllAndHidesNoOther) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Random random(3);
  std::vector<Aabb> boxes = randomBoxes(50, random);
  boxes[20] = {Eigen::Vector3d::Constant(-kFar), Eigen::Vector3d(kFar, kFar, 0.0)};
  const RigidTree tree(boxes);
  std::vector<bool> is_visited(boxes.size(), false);
  tree.visitMeeting(smallBoxOf(boxes[7]), [&](std::uint32_t body) { is_visited[body] = true; });
  EXPECT_TRUE(is_visited[7]);
  EXPECT_EQ(is_visited[20], boxes[7].min.z() <= 0.0);
}

TEST(RigidTree, noBodies_visitsNothing) {
  const RigidTree tree({});
  tree.visitNear(Eigen::Vector3d::Zero(), 1.0, [](std::uint32_t) { FAIL(); });
}

}  // namespace
}  // namespace collision_monitor::test
