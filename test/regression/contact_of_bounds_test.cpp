// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause

// Users saw contacts that only a spent budget had made stay for as long as the budget was short.
// A search that stops where the hysteresis ends kept that distance, which the hysteresis held.
// Now the memory of a contact says what showed it, and whatever is finer and apart ends it.
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "support/sample_meshes.h"
#include "unit/pipeline/refine/refine_scene.h"

namespace collision_monitor::test {
namespace {

using Scene = RefineScene;

/// Hooked angles, 1 mm apart and so within the hysteresis of a contact, that rest.
Scene restingAngles() {
  Scene scene = hookedAngles(RefineGeometry::mesh);
  scene.poses.world_from_link[1].translation.y() -= 0.019;
  std::fill(scene.poses.velocities.known.begin(), scene.poses.velocities.known.end(), 1);
  return scene;
}

TEST(ContactOfBounds, contactOfEnclosingShapesAlone_endsWhenTheGeometriesAreSeenApart) {
  Scene scene = restingAngles();
  const auto budget = scene.buffers.refine.limits.budget;
  scene.buffers.refine.limits.budget = 0;
  scene.run();
  scene.run();
  ASSERT_EQ(scene.verdict(), Verdict::contact);
  EXPECT_EQ(scene.buffers.memory.speed.scale, 0.0) << "what may touch is stopped";
  scene.buffers.refine.limits.budget = budget;
  scene.poses.stamp_ns += 1'000'000'000;
  scene.run();
  EXPECT_EQ(scene.closest().quality, Quality::exact);
  EXPECT_NEAR(scene.closest().measured.distance, 0.001, 1e-9);
  EXPECT_EQ(scene.verdict(), Verdict::warning) << "hysteresis holds contacts, not the want of work";
  EXPECT_EQ(scene.buffers.memory.speed.scale, 1.0) << "nor is it stopped";
}

TEST(ContactOfBounds, contactOfTheGeometries_isHeldByHysteresis) {
  Scene scene = restingAngles();
  Eigen::Vector3d& place = scene.poses.world_from_link[1].translation;
  place.y() -= 0.002;
  scene.run();
  ASSERT_EQ(scene.verdict(), Verdict::contact);
  place.y() += 0.002;
  scene.run();
  EXPECT_NEAR(scene.closest().measured.distance, 0.001, 1e-9);
  EXPECT_EQ(scene.verdict(), Verdict::contact);
}

/// A ball in the hollow of a shell, twice, far from each other: apart, and everywhere by nearly the
/// same distance, which takes long to find.
Scene ballsInHollowShells() {
  const TriangleMesh ball = test::sphereMesh(0.1, 24);
  TriangleMesh hollow = test::sphereMesh(0.19, 24);
  for (auto& [a, b, c] : hollow.triangles) {
    std::swap(b, c);
  }
  const TriangleMesh shell = test::joined(test::sphereMesh(0.2, 24), hollow);
  Scene scene({ball, shell, ball, shell});
  scene.moveTo(2, 5.0);
  scene.moveTo(3, 5.0);
  return scene;
}

/// What decides of each pair that it is in no contact, and finds no distance to the end.
std::uint32_t budgetOfDecisions() {
  Scene scene = ballsInHollowShells();
  scene.buffers.refine.limits.budget = 1000000;
  scene.run();
  return static_cast<std::uint32_t>(scene.buffers.counters.refine_work / 2);
}

TEST(ContactOfBounds, contactOfEnclosingShapesAlone_endsWhenASearchProvesItNone) {
  Scene scene = ballsInHollowShells();
  scene.buffers.refine.limits.budget = 0;
  scene.run();
  ASSERT_EQ(scene.buffers.events.overall, Verdict::contact);
  scene.buffers.refine.limits.budget = budgetOfDecisions();
  scene.run();
  ASSERT_GT(scene.buffers.counters.left, 0U);
  EXPECT_NE(scene.buffers.events.overall, Verdict::contact);
}

TEST(ContactOfBounds, contactOfTheGeometries_endsWhenASearchProvesThemFartherThanHysteresis) {
  Scene scene = ballsInHollowShells();
  scene.moveTo(0, 0.1);
  scene.moveTo(2, 5.1);
  scene.run();
  ASSERT_EQ(scene.buffers.events.overall, Verdict::contact);
  scene.moveTo(0, 0.0);
  scene.moveTo(2, 5.0);
  forgetPoses(scene.buffers);
  scene.buffers.refine.limits.budget = budgetOfDecisions();
  scene.run();
  ASSERT_GT(scene.buffers.counters.left, 0U);
  EXPECT_NE(scene.buffers.events.overall, Verdict::contact);
}

}  // namespace
}  // namespace collision_monitor::test
