// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "broad_phase/rigid_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "geometry/constants.h"
#include "narrow_phase/distance.h"
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

TEST(RigidTree, orientedBoxOfAnySize_findsEveryBodyThatIsNear) {
  Random random(1);
  for (const std::size_t count : {1U, 2U, 8U, 9U, 100U, 1000U}) {
    const std::vector<Aabb> boxes = randomBoxes(count, random);
    const RigidTree tree(boxes);
    std::vector<std::uint32_t> room(tree.roomForFound());
    for (int i = 0; i < 100; ++i) {
      const Pose pose = randomPose(random, 1.0);
      const Box asked{randomPoint(random, 0.3).cwiseAbs()};
      const double within = 0.1 * static_cast<double>(random() % 3);
      std::vector<int> times(count, 0);
      for (const std::uint32_t body :
           tree.findNear(nearBoxOf(pose, asked.half_extents, within), room)) {
        ++times[body];
      }
      for (std::size_t body = 0; body < count; ++body) {
        const Eigen::Vector3d half = 0.5 * (boxes[body].max - boxes[body].min);
        const Pose place{Eigen::Matrix3d::Identity(), 0.5 * (boxes[body].max + boxes[body].min)};
        const double distance = distanceBetween(asked, pose, Box{half}, place).distance;
        EXPECT_LE(times[body], 1);
        EXPECT_TRUE(times[body] == 1 || distance > within);
        // Along each axis the box reaches at most its half diagonal beyond its center.
        EXPECT_TRUE(times[body] == 0 || distance <= within + 3.0 * half.norm() + 1e-4);
      }
    }
  }
}

TEST(RigidTree, distanceThatIsNotKnown_findsEveryBody) {
  Random random(4);
  const RigidTree tree(randomBoxes(77, random));
  std::vector<std::uint32_t> room(tree.roomForFound());
  for (const double within : {kInfinity, std::numeric_limits<double>::quiet_NaN(), 1e300}) {
    const FoundBodies found =
        tree.findNear(nearBoxOf(Pose(), Eigen::Vector3d::Zero(), within), room);
    EXPECT_EQ(found.end() - found.begin(), 77);
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

TEST(RigidTree, boxWithoutBounds_isNearAllAndHidesNoOther) {
  Random random(3);
  std::vector<Aabb> boxes = randomBoxes(50, random);
  boxes[20] = {Eigen::Vector3d::Constant(-kInfinity), Eigen::Vector3d(kInfinity, kInfinity, 0.0)};
  const RigidTree tree(boxes);
  std::vector<std::uint32_t> room(tree.roomForFound());
  const Pose place{Eigen::Matrix3d::Identity(), 0.5 * (boxes[7].max + boxes[7].min)};
  const FoundBodies found = tree.findNear(nearBoxOf(place, Eigen::Vector3d::Zero(), 0.0), room);
  EXPECT_EQ(std::count(found.begin(), found.end(), 7U), 1);
  EXPECT_EQ(std::count(found.begin(), found.end(), 20U), 1);
}

TEST(RigidTree, noBodies_visitsNothing) {
  const RigidTree tree({});
  std::vector<std::uint32_t> room(tree.roomForFound());
  const FoundBodies found = tree.findNear(nearBoxOf(Pose(), Eigen::Vector3d::Zero(), 1.0), room);
  EXPECT_EQ(found.begin(), found.end());
  tree.visitNear(Eigen::Vector3d::Zero(), 1.0, [](std::uint32_t) { FAIL(); });
}

}  // namespace
}  // namespace collision_monitor::test
