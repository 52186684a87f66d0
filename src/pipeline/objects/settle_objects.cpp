// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/objects/settle_objects.h"

#include "pipeline/objects/object_trees.h"

namespace collision_monitor {

void settleObjects(const CycleSetup& setup, const LinkPoses& poses,
                   CycleBuffers& buffers) noexcept {
  SweepWork& sweep = buffers.sweep;
  for (const CarriedObjects& objects : setup.carried) {
    for (std::size_t link = objects.first_link; link < objects.last_link; ++link) {
      sweep.has_motion[link] = sweep.had_motion[link] = 1;
      sweep.link_motions[link] = sweep.last_motions[link] = {poses.world_from_link[link]};
    }
    for (std::size_t body = objects.first_body; body < objects.last_body; ++body) {
      buffers.bounds.ahead[body] = buffers.memory.distance_cache.travels[body].ahead = 0.0;
    }
  }
  growTrees(setup, buffers);
}

}  // namespace collision_monitor
