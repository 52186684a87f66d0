// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "broad_phase/broad_phase.h"
#include "collision_monitor/pipeline/setup.h"
#include "pipeline/data/cycle_data.h"
#include "pipeline/look_ahead/link_walk.h"
#include "pipeline/refine/refine_pairs.h"
#include "pipeline/refine/sweep_pairs.h"

namespace collision_monitor {

/// All arrays of one cycle, sized so that no cycle allocates.
struct CycleBuffers {
  BodyPoses body_poses;
  BodyBounds bounds;
  ActivationDistances activation;
  std::vector<PairId> candidates;
  std::vector<PairId> deferred;  ///< as measureDeferred
  PairDistances distances;
  RefineWork refine;
  SweepWork sweep;
  PairEvents events;
  PairMemory memory;
  CycleCounters counters;
  BroadPhase broad_phase;
  bool culls_by_boxes{false};  ///< BroadPhaseKind::combination
};

CycleBuffers makeBuffers(const CycleSetup& setup, BroadPhaseKind kind);

/// Forgets where links were: after a jump in time, or when nobody was told. What happened between
/// the last cycle and the next one is then not looked into. The verdicts that were reported and the
/// speed scale stay: they hold until new poses say otherwise.
void forgetPoses(CycleBuffers& buffers) noexcept;

/// Forgets all that earlier cycles left, as if there had been none.
void resetMemory(CycleBuffers& buffers) noexcept;

}  // namespace collision_monitor
