// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/parts/cut_and_join.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/sample_meshes.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;
using test::boxMesh;
using test::boxMeshAt;
using test::joined;

/// Two bars of 0.4 m along x, 0.3 m apart, and one of 0.3 m along y between their ends at x > 0.
TriangleMesh threeBars() {
  return joined(joined(boxMeshAt({0.2, 0.015, 0.015}, {0.0, 0.135, 0.0}),
                       boxMeshAt({0.2, 0.015, 0.015}, {0.0, -0.135, 0.0})),
                boxMeshAt({0.015, 0.15, 0.015}, {0.185, 0.0, 0.0}));
}

/// Points of the part of a plan, as its cuts say.
std::vector<Vector3d> partOf(const Points& points, const CutPlan& plan, std::uint32_t part) {
  std::vector<Vector3d> inside;
  for (const Vector3d& point : points) {
    std::uint32_t at = 0;
    for (std::size_t i = 0; i < plan.cuts.size(); ++i) {
      const PartCut& cut = plan.cuts[i];
      if (cut.part == at && cut.normal.dot(point) > cut.offset) {
        at = static_cast<std::uint32_t>(i + 1);
      }
    }
    if (at == part) {
      inside.push_back(point);
    }
  }
  return inside;
}

TEST(PlanCuts, whatFillsItsHull_isNotCut) {
  const CutPlan plan = planCuts(DistanceGrid(boxMesh({0.1, 0.2, 0.3})), 4, 0.0);
  EXPECT_TRUE(plan.cuts.empty());
  EXPECT_EQ(plan.shapes, 1u);
  EXPECT_EQ(plan.shape_of, std::vector<std::uint32_t>{0});
}

TEST(PlanCuts, targetThatIsMet_isNotCut) {
  EXPECT_TRUE(planCuts(DistanceGrid(threeBars()), 4, 0.2).cuts.empty());
}

TEST(PlanCuts, barsInAU_areOneShapeEach) {
  const DistanceGrid grid(threeBars());
  const CutPlan plan = planCuts(grid, 4, 0.0);
  EXPECT_EQ(plan.shapes, 3u) << "a fourth would be of no use";
  ASSERT_EQ(plan.shape_of.size(), plan.cuts.size() + 1);
  std::vector<Points> held(plan.shapes);
  for (std::uint32_t part = 0; part < plan.shape_of.size(); ++part) {
    const Points points = partOf(grid.surface(), plan, part);
    EXPECT_FALSE(points.empty());
    Points& shape = held.at(plan.shape_of[part]);
    shape.insert(shape.end(), points.begin(), points.end());
  }
  for (const Points& points : held) {
    Vector3d low = points.front();
    Vector3d high = low;
    for (const Vector3d& point : points) {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
    Vector3d sides = high - low;
    std::sort(sides.begin(), sides.end());
    EXPECT_LT(sides[1], 0.045) << "0.03 and what a cut beside the corner leaves";
  }
}

TEST(PlanCuts, fewShapes_shareWhatGrowsLeast) {
  const CutPlan plan = planCuts(DistanceGrid(threeBars()), 2, 0.0);
  EXPECT_EQ(plan.shapes, 2u);
  EXPECT_EQ(planCuts(DistanceGrid(threeBars()), 1, 0.0).shapes, 1u);
}

TEST(PlanCuts, flatAndThinThings_end) {
  const TriangleMesh flat{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {2, 1, 0}}, {{0, 1, 2}, {1, 2, 3}}};
  const TriangleMesh line{{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}}};
  const TriangleMesh point{{{1, 2, 3}}, {}};
  for (const auto& mesh : {flat, line, point}) {
    const CutPlan plan = planCuts(DistanceGrid(mesh), 3, 0.0);
    EXPECT_GE(plan.shapes, 1u);
    EXPECT_LE(plan.shapes, 3u);
  }
}

}  // namespace
}  // namespace collision_monitor
