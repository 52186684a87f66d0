// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "broad_phase/broad_phase.h"
#include "collision_monitor/pipeline/setup.h"
#include "pipeline/data/cycle_data.h"
#include "pipeline/data/robot_speeds.h"
#include "pipeline/look_ahead/link_walk.h"
#include "pipeline/objects/object_trees.h"
#include "pipeline/refine/refine_pairs.h"
#include "pipeline/refine/sweep_pairs.h"

namespace collision_monitor {

/// All arrays of a cycle, sized so that no cycle allocates.
struct CycleBuffers {
  BodyPoses body_poses;
  BodyBounds bounds;
  ActivationDistances activation;
  std::vector<PairId> candidates;
  std::vector<PairId> deferred;  ///< for measureDeferred
  std::size_t passed_over{0};    ///< pairs that SettledPairs left out
  PairDistances distances;
  RefineWork refine;
  SweepWork sweep;
  PairEvents events;
  PairMemory memory;
  RobotSpeeds robots;  ///< survives a cycle, like `memory`
  CycleCounters counters;
  BroadPhase broad_phase;  ///< of all bodies, or of the loose ones
  ObjectTrees trees;
  bool culls_by_boxes{false};  ///< as in BroadPhaseKind::combination
};

CycleBuffers makeBuffers(const CycleSetup& setup, BroadPhaseKind kind);

/// Forgets the poses of the last cycle: after a jump in time, or when no verdicts were reported.
/// The next cycle then looks for no contacts since the last one, and measures anew what is near.
/// Reported verdicts and the speed scale stay until new poses change them.
void forgetPoses(CycleBuffers& buffers) noexcept;

/// Forgets the verdicts that were reported and the speed scales, as if nobody had heard of them.
void forgetReported(CycleBuffers& buffers) noexcept;

/// Forgets everything that earlier cycles left.
void resetMemory(CycleBuffers& buffers) noexcept;

}  // namespace collision_monitor
