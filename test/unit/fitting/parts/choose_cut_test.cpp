// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/parts/choose_cut.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "fitting/shapes/rough_fit.h"
#include "support/sample_meshes.h"

namespace collision_monitor {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

using Skipped = std::array<unsigned char, PointRows::kMost>;

const auto kNothing = [](const PointRows&, Skipped& is_skipped) { is_skipped.fill(0); };
const auto kToTheEnd = [](const OvershootSum&) { return false; };

RoughGoal plainGoal(const DistanceGrid& grid) { return {grid, {}, {}, {}}; }

TEST(RoughOvershoot, boxAroundABall_sticksOutAtItsCorners) {
  const DistanceGrid grid(test::sphereMesh(0.1, 48));
  TurnedCore box;
  box.half_extents = Vector3d::Constant(0.1);
  const Overshoot overshoot = roughOvershoot(box, grid, kNothing, kToTheEnd).total();
  EXPECT_NEAR(overshoot.max, 0.1 * (std::sqrt(3.0) - 1.0), grid.spacing());
  EXPECT_LT(overshoot.mean, overshoot.fourth_power_mean);
  EXPECT_LT(overshoot.fourth_power_mean, overshoot.max);
}

TEST(RoughOvershoot, pointsThatDoNotCount_areLeftOut) {
  const DistanceGrid grid(test::sphereMesh(0.1, 48));
  TurnedCore box;
  box.half_extents = {0.1, 0.1, 0.3};  // half of it reaches far above and below the ball
  const auto far = [](const PointRows& points, Skipped& is_skipped) {
    for (std::size_t i = 0; i < points.count; ++i) {
      is_skipped[i] = !(std::abs(points.at[2][i]) < 0.1);
    }
  };
  EXPECT_GT(roughOvershoot(box, grid, kNothing, kToTheEnd).total().max, 0.2);
  EXPECT_LT(roughOvershoot(box, grid, far, kToTheEnd).total().max, 0.08);
}

TEST(RoughGoal, pointsInOtherShapes_doNotCount) {
  const DistanceGrid grid(test::boxMesh({0.1, 0.1, 0.1}));
  TurnedCore wide;
  wide.half_extents = {0.3, 0.1, 0.1};
  RoughGoal goal = plainGoal(grid);
  EXPECT_NEAR(goal.overshootOf(wide).total().max, 0.2, grid.spacing());
  TurnedCore right = wide;
  right.center = {0.25, 0.0, 0.0};
  right.half_extents = {0.15, 0.11, 0.11};
  TurnedCore left = right;
  left.center.x() = -0.25;
  goal.others = {right, left};
  EXPECT_LT(goal.overshootOf(wide).total().max, grid.spacing());
}

TEST(RoughGoal, boundedCost_isTheCostBelowTheBoundAndNotBelowItElse) {
  const DistanceGrid grid(test::sphereMesh(0.1, 48));
  const RoughGoal goal = plainGoal(grid);
  TurnedCore core;
  core.half_extents = {0.1, 0.08, 0.06};
  core.radius = 0.03;
  const double cost = goal.costOf(core);
  EXPECT_GT(cost, 0.01);
  EXPECT_EQ(goal.costOf(core, 1.0001 * cost), cost);
  for (const double fraction : {0.01, 0.3, 0.9, 1.0}) {
    EXPECT_GE(goal.costOf(core, fraction * cost), fraction * cost);
    EXPECT_LE(goal.costOf(core, fraction * cost), cost * (1.0 + 1e-12));
  }
}

TEST(FitRoughly, turnedBox_isThatBox) {
  const TriangleMesh mesh = test::moved(test::boxMesh({0.3, 0.2, 0.1}), {0.3, 0.4, 0.5}, {1, 0, 0});
  const DistanceGrid grid(mesh);
  const Vector3d turn(0.3, 0.4, 0.5);
  const Matrix3d frame = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
  const RoughFit fit = fitRoughly(mesh.vertices, {Matrix3d::Identity(), frame}, plainGoal(grid));
  const PosedShape shape = placedShape(fit);
  EXPECT_STREQ(kindName(shape.shape), "box");
  EXPECT_NEAR(volumeOf(shape.shape), 8 * 0.3 * 0.2 * 0.1, 1e-9);
  EXPECT_LE(excessOver(shape, mesh.vertices), 1e-12);
}

TEST(FitRoughly, oneKindAllowed_isTaken) {
  const TriangleMesh mesh = test::boxMesh({0.3, 0.2, 0.1});
  const DistanceGrid grid(mesh);
  for (std::size_t kind = 0; kind < std::variant_size_v<Shape>; ++kind) {
    RoughGoal goal = plainGoal(grid);
    goal.kinds = {kind == 0, kind == 1, kind == 2, kind == 3};
    const RoughFit fit = fitRoughly(mesh.vertices, {Matrix3d::Identity()}, goal);
    EXPECT_EQ(fit.kind, kind);
    EXPECT_LE(excessOver(placedShape(fit), mesh.vertices), 1e-12);
  }
}

TEST(Polished, crookedBox_isStraightened) {
  const TriangleMesh mesh = test::boxMesh({0.3, 0.2, 0.1});
  const DistanceGrid grid(mesh);
  const Matrix3d crooked =
      Eigen::AngleAxisd(0.3, Vector3d(1, 1, 1).normalized()).toRotationMatrix();
  RoughGoal goal = plainGoal(grid);
  goal.kinds = {false, false, true, false};
  const RoughFit before = fitRoughly(mesh.vertices, {crooked}, goal);
  const RoughFit after = polished(before, mesh.vertices, goal);
  EXPECT_LT(after.cost, 0.5 * before.cost);
  EXPECT_LE(excessOver(placedShape(after), mesh.vertices), 1e-12);
}

TEST(ChooseCut, hammer_isCutBetweenHeadAndHandle) {
  const TriangleMesh head =
      test::moved(test::boxMesh({0.05, 0.12, 0.05}), Vector3d::Zero(), {0.25, 0.0, 0.0});
  const DistanceGrid grid(test::joined(test::boxMesh({0.2, 0.02, 0.02}), head));
  TurnedCore whole;
  whole.center = {0.05, 0.0, 0.0};
  whole.half_extents = {0.25, 0.12, 0.05};
  const auto cut = chooseCut(grid.surface(), whole, plainGoal(grid));
  ASSERT_TRUE(cut.has_value());
  EXPECT_NEAR(std::abs(cut->plane.normal.x()), 1.0, 1e-9);
  EXPECT_NEAR(cut->plane.offset / cut->plane.normal.x(), 0.2, 0.02);
  EXPECT_LT(cut->cost, 0.02);
}

TEST(ChooseCut, onePoint_cannotBeCut) {
  const DistanceGrid grid(TriangleMesh{{{1, 2, 3}}, {}});
  EXPECT_FALSE(chooseCut({{1, 2, 3}}, TurnedCore(), plainGoal(grid)).has_value());
}

}  // namespace
}  // namespace collision_monitor
