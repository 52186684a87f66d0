// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause

// Users saw links called in contact that were apart, since hard distances had spent the budget.
// Pairs were measured to the end one after the other, and what was left kept its enclosing shapes.
// Now contacts of all pairs are decided before any distance is looked for.
#include <gtest/gtest.h>

#include <utility>

#include "support/sample_meshes.h"
#include "unit/pipeline/refine/refine_scene.h"

namespace collision_monitor::test {
namespace {

using Scene = RefineScene;

/// A ball in the hollow of a thick shell, twice, far from each other: they are apart, and
/// everywhere by nearly the same distance, which takes long to find.
Scene ballsInShells() {
  TriangleMesh ball = test::sphereMesh(0.1, 24);
  ball.triangles.pop_back();
  TriangleMesh hollow = test::sphereMesh(0.2, 24);
  for (auto& triangle : hollow.triangles) {
    std::swap(triangle[0], triangle[1]);
  }
  const TriangleMesh shell = test::joined(test::sphereMesh(0.3, 24), hollow);
  Scene scene({ball, shell, ball, shell});
  scene.moveTo(2, 5.0);
  scene.moveTo(3, 5.0);
  return scene;
}

TEST(FalseAlarmsOfBudget, budgetOfOneDistance_noContactOfEnclosingShapesIsLeft) {
  Scene scene = ballsInShells();
  scene.buffers.refine.limits.budget = 1000000;
  scene.run();
  ASSERT_EQ(scene.buffers.counters.left, 0U);
  ASSERT_GT(scene.closest().measured.distance, 0.09);
  resetMemory(scene.buffers);
  scene.buffers.refine.limits.budget =
      static_cast<std::uint32_t>(scene.buffers.counters.refine_work / 2);
  scene.run();
  EXPECT_GT(scene.buffers.counters.left, 0U);
  EXPECT_NE(scene.buffers.events.overall, Verdict::contact);
  for (const PairDistance& pair : scene.buffers.distances.pairs) {
    EXPECT_GE(pair.measured.distance, 0.002) << "as much as it takes to be in no contact";
  }
}

}  // namespace
}  // namespace collision_monitor::test
