// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/gjk/support_plane.h"

#include <gtest/gtest.h>

#include <vector>

#include "narrow_phase/gjk/convex_core.h"
#include "support/random_poses.h"

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

ConvexHull randomHull(Random& random) {
  std::vector<Vector3d> points(20);
  for (Vector3d& point : points) {
    point = randomPoint(random, 1.0).normalized();
  }
  return ConvexHull(points);
}

// Unit, perpendicular to an edge, and beyond no face beside it.
Vector3d across(const ConvexHull& hull, const ConvexHull::Edge& edge) {
  const Vector3d along = (hull.vertices()[edge.to] - hull.vertices()[edge.from]).normalized();
  const Vector3d outward = hull.faces()[edge.left].normal + hull.faces()[edge.right].normal;
  return (outward - along.dot(outward) * along).normalized();
}

// Rounding tells which end of an edge is farther across it. A look at either stays there.
TEST(SupportPlane, endsOfAnEdge_bothStayTheFarthest) {
  Random random(20260101);
  int farther = 0;
  for (int i = 0; i < 20; ++i) {
    const ConvexHull hull = randomHull(random);
    const ConvexCore core = inflatedCoreOf(hull).core;
    for (const ConvexHull::Edge& edge : hull.edges()) {
      const Vector3d direction = across(hull, edge);
      for (const std::uint32_t end : {edge.from, edge.to}) {
        const ExtremeFeature found = extremeOf(core, direction, end);
        EXPECT_EQ(found.vertex, end);
        EXPECT_TRUE(found.may_be_level);
        farther += found.reach > along(direction, hull.vertices()[end]) ? 1 : 0;
      }
    }
  }
  EXPECT_GT(farther, 100) << "hulls of which rounding prefers no end test nothing";
}

TEST(SupportPlane, endFartherByMoreThanRounding_isClimbedTo) {
  Random random(20260101);
  for (int i = 0; i < 20; ++i) {
    const ConvexHull hull = randomHull(random);
    const ConvexCore core = inflatedCoreOf(hull).core;
    for (const ConvexHull::Edge& edge : hull.edges()) {
      const Vector3d delta = hull.vertices()[edge.to] - hull.vertices()[edge.from];
      const Vector3d direction = across(hull, edge) + 1e-14 / delta.squaredNorm() * delta;
      EXPECT_EQ(extremeOf(core, direction, edge.from).vertex, edge.to);
    }
  }
}

}  // namespace
}  // namespace collision_monitor::test
