// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/refine/decide_contact.h"

#include <gtest/gtest.h>

#include "../setup/open_torso.h"
#include "refine_scene.h"

namespace collision_monitor::test {
namespace {

constexpr double kCutoff = 0.002001;  // [m] of optionsFor: the hysteresis and a little more

/// Two hooked angles, 2 cm apart. All that is remembered is that they are beyond the cutoff.
class DecideContact : public testing::Test {
 protected:
  void SetUp() override {
    scene_.run();
    ElementDistance apart;
    apart.quality = Quality::lower_bound;
    apart.measured.distance = kCutoff;
    apart.is_complete = true;
    std::vector<Pose>& placed = scene_.buffers.body_poses.world_from_element;
    scene_.buffers.memory.refined.of(0).last = {apart, placed[0], placed[1]};
  }

  /// The work of a decision after one has moved by `step` [m].
  std::size_t workAfter(double step) {
    CycleBuffers& buffers = scene_.buffers;
    buffers.body_poses.world_from_element[1].translation.y() += step;
    buffers.refine.work_done = 0;
    RefineTask task{0};
    task.bound = -0.01;
    decideContact(
        {scene_.setup, buffers.body_poses, buffers.memory, buffers.refine, buffers.distances},
        task);
    return buffers.refine.work_done;
  }

  RefineScene scene_ = hookedAngles(RefineGeometry::mesh);
};

TEST_F(DecideContact, boundOfWhichHalfIsLeft_isNotProvenAgain) {
  EXPECT_EQ(workAfter(0.4 * kCutoff), 0U);
  EXPECT_GT(workAfter(0.2 * kCutoff), 0U) << "less than half is left";
  EXPECT_EQ(workAfter(0.1 * kCutoff), 0U) << "it is whole again";
}

TEST_F(DecideContact, reportedContact_endsAtTheWholeCutoff) {
  scene_.buffers.memory.reported[0] = Verdict::contact;
  EXPECT_GT(workAfter(0.1 * kCutoff), 0U);
}

/// A forearm goes down into a bin that is open above. Far above, their hulls are apart.
TEST(DecideContactOfOpenMeshes, throughTheHole_isNotTakenForApart) {
  RefineScene scene({open_meshes::bin(), open_meshes::forearm()});
  scene.moveTo(1, 1.0);
  scene.run();
  CycleBuffers& buffers = scene.buffers;
  const Refinement all{scene.setup, buffers.body_poses, buffers.memory, buffers.refine,
                       buffers.distances};
  Pose& forearm = buffers.body_poses.world_from_element[1];
  for (int step = 0; step <= 600; ++step) {
    forearm.translation = {0.03, 0.02, 0.3 - 0.0005 * step};
    buffers.refine.work_done = 0;
    RefineTask task{0};
    task.bound = -0.01;
    decideContact(all, task);
  }
  const LastMeasurement& last = buffers.memory.refined.lastOf(0);
  const bool is_recent = last.world_from_b.translation == forearm.translation;
  EXPECT_FALSE(is_recent && last.found.quality == Quality::lower_bound) << "it is inside";
  EXPECT_LE(last.found.outside, 0.3) << "a bin has a hole";
}

}  // namespace
}  // namespace collision_monitor::test
