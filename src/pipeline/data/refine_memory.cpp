// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/data/refine_memory.h"

#include <algorithm>
#include <utility>

#include "collision_monitor/geometry/ids.h"
#include "geometry/ball_motion.h"

namespace collision_monitor {
void remember(const LastMeasurement& measurement, RefineMemory& memory) noexcept {
  if (!isSame(memory.last.world_from_a, measurement.world_from_a) ||
      !isSame(memory.last.world_from_b, measurement.world_from_b)) {
    memory.before = memory.last;
  }
  memory.last = measurement;
}

void forget(RefineMemory& memory) noexcept {
  MeshFront* const front = memory.front;
  KeptDepth* const depth = memory.depth;
  FixedRoom<KeptDepth>* const depths = memory.depths;
  memory = RefineMemory();
  memory.front = front;
  memory.depth = depth;
  memory.depths = depths;
  if (memory.front != nullptr) {
    memory.front->pool.clear(*memory.front);
    memory.front->resting_from_moving.reset();
    memory.front->nearest.a = kNone;
  }
  if (memory.depth != nullptr) {
    forget(*memory.depth);
  }
}

KeptDepth* keptDepth(RefineMemory& memory) noexcept {
  if (memory.depth == nullptr && memory.depths != nullptr) {
    memory.depth = &memory.depths->make();
  }
  return memory.depth;
}

}  // namespace collision_monitor
