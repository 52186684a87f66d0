// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/data/refine_memory.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "collision_monitor/geometry/ids.h"
#include "geometry/ball_motion.h"

namespace collision_monitor {

WitnessPoints witnessOf(const LastMeasurement& measurement) noexcept {
  const ElementDistance& found = measurement.found;
  const bool is_distance = found.quality != Quality::estimate && found.measured.distance > 0.0;
  if (!found.has_points || !found.is_complete || !is_distance) {
    return {};
  }
  return {inverse(measurement.world_from_a) * found.measured.point_on_a,
          inverse(measurement.world_from_b) * found.measured.point_on_b, found.shortfall,
          found.quality};
}

void remember(const LastMeasurement& measurement, RefineMemory& memory) noexcept {
  if (!isSame(memory.last.world_from_a, measurement.world_from_a) ||
      !isSame(memory.last.world_from_b, measurement.world_from_b)) {
    memory.before = memory.last;
  }
  const WitnessPoints known = memory.last.witness;
  const WitnessPoints found = witnessOf(measurement);
  memory.last = measurement;
  memory.last.witness = std::isinf(found.error) ? known : found;
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
    std::fill_n(memory.front->probes.first, memory.front->probes.count, KeptProbe());
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
