// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause

// Users that allow some depth missed contacts of concave meshes while the budget was short.
// A bound between the depth allowed and 0 was taken for a proof that there is no contact.
// Now such a bound proves nothing: concave geometries that overlap are in contact however deep.
#include <gtest/gtest.h>

#include "unit/pipeline/refine/refine_scene.h"

namespace collision_monitor::test {
namespace {

TEST(BoundBelowZero, contactOfSomeDepth_isNotRuledOutByABoundBelowZero) {
  SetupOptions options;
  options.default_limits.max_shapes = 1;
  options.limits.contact_distance = -0.003;
  options.limits.hysteresis = 0.0;
  RefineScene scene({angleMesh(), angleMesh()}, options);
  scene.poses.world_from_link[1] = hookedPose();
  scene.poses.world_from_link[1].translation.y() -= 0.0195;  // 0.5 mm apart
  scene.run();
  ASSERT_NE(scene.verdict(), Verdict::contact);
  scene.poses.world_from_link[1].translation.y() -= 0.002;
  scene.buffers.refine.limits.budget = 0;
  scene.run();
  EXPECT_EQ(scene.verdict(), Verdict::contact);
}

}  // namespace
}  // namespace collision_monitor::test
