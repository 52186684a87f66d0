// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "narrow_phase/triangle/triangle_edges.h"
#include "support/expect_distance.h"
#include "support/instruction_sets.h"

namespace collision_monitor::test {
namespace {

using Eigen::Vector3d;

class EdgeLanes : public testing::TestWithParam<std::int64_t> {
 protected:
  /// The edges that are nearest, and how far apart.
  static void expectNearest(const Triangle& b, std::size_t of_a, std::size_t of_b,
                            double squared_distance) {
    const EdgePair found = nearestEdges(prepare(kFlat), prepare(b));
    EXPECT_EQ(found.a, of_a);
    EXPECT_EQ(found.b, of_b);
    EXPECT_NEAR(found.squared_distance, squared_distance, kExact);
  }

  // Edge 0 along x, edge 1 from (4, 0) to (0, 4), edge 2 along y.
  inline static const Triangle kFlat = {Vector3d(0, 0, 0), Vector3d(4, 0, 0), Vector3d(0, 4, 0)};
  OnlyInstructionSet only_{GetParam()};
};
INSTANTIATE_TEST_SUITE_P(EveryInstructionSet, EdgeLanes, testing::ValuesIn(instructionSets()),
                         [](const auto& target) { return hwy::TargetName(target.param); });

TEST_P(EdgeLanes, edgesThatCrossAtADistance_byTheLinesBetween) {
  // Its edge 1 runs along y over the middle of A's edge 0, two above it.
  expectNearest({Vector3d(2, 0, 9), Vector3d(2, -5, 2), Vector3d(2, 0.5, 2)}, 0, 1, 4.0);
}

TEST_P(EdgeLanes, parallelEdges_byTheirLines) {
  expectNearest({Vector3d(1, -3, 0), Vector3d(3, -3, 0), Vector3d(2, -9, 0)}, 0, 0, 9.0);
  expectNearest({Vector3d(-1, 3, 0), Vector3d(-1, 1, 0), Vector3d(-9, 2, 0)}, 2, 0, 1.0);
}

TEST_P(EdgeLanes, endToEnd_byTheCorners) {
  expectNearest({Vector3d(7, 0, 4), Vector3d(17, 0, 4), Vector3d(17, 3, 4)}, 0, 0, 25.0);
}

TEST_P(EdgeLanes, pointsForTriangles_areNoDivisionByZero) {
  const Vector3d point(2, -3, 4);
  expectNearest({point, point, point}, 0, 0, 25.0);
  const PreparedTriangle none = prepare({point, point, point});
  EXPECT_EQ(nearestEdges(none, none).squared_distance, 0.0);
  EXPECT_NEAR(nearestEdges(none, prepare(kFlat)).squared_distance, 25.0, kExact);
}

}  // namespace
}  // namespace collision_monitor::test
