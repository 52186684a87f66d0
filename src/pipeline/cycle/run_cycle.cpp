// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/cycle/run_cycle.h"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "collision_monitor/geometry/ids.h"
#include "pipeline/cycle/cull_candidates.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/distance_cache.h"
#include "pipeline/cycle/judge_pairs.h"
#include "pipeline/cycle/keep_near.h"
#include "pipeline/cycle/list_near.h"
#include "pipeline/cycle/measure_pairs.h"
#include "pipeline/cycle/measure_told.h"
#include "pipeline/cycle/place_bodies.h"
#include "pipeline/cycle/scale_speed.h"
#include "pipeline/cycle/settled_pairs.h"
#include "pipeline/data/activation_distance.h"
#include "pipeline/look_ahead/bound_bodies.h"
#include "pipeline/look_ahead/find_closings.h"
#include "pipeline/look_ahead/find_motions.h"
#include "pipeline/look_ahead/link_walk.h"
#include "pipeline/objects/find_resting.h"
#include "pipeline/objects/settle_objects.h"

namespace collision_monitor {
namespace {

void countUnknown(const CycleSetup& setup, const BodyPoses& body_poses,
                  CycleCounters& counters) noexcept {
  counters.unknown_links = 0;
  counters.unknown_pairs = 0;
  for (std::size_t link = 0; link < setup.model.links.size(); ++link) {
    if (hasShapes(setup.model.links[link]) && body_poses.link_known[link] == 0) {
      ++counters.unknown_links;
    }
  }
  if (counters.unknown_links == 0 && !body_poses.is_split) {
    return;
  }
  for (const BodyPair& pair : setup.table.pairs()) {
    if (!isJoined(body_poses, setup.bodies[index(pair.a)].link, setup.bodies[index(pair.b)].link)) {
      ++counters.unknown_pairs;
    }
  }
}

/// Whether links became known, unknown or parts of something else since the last cycle.
bool haveLinksChanged(const BodyPoses& body_poses, const LastPoses& last) noexcept {
  bool have_changed = false;
  forIndices(body_poses.moved.links, [&](std::size_t link) noexcept {
    have_changed |= body_poses.link_known[link] != last.known[link];
    have_changed |= body_poses.part[link] != last.part[link];
  });
  return have_changed;
}

void place(const CycleSetup& setup, const LinkPoses& poses, BodyPoses& body_poses) noexcept {
  placeBodies(setup, poses, body_poses);
  placeElements(setup, poses, body_poses);
}

/// Lists the pairs that can be near.
void list(const CycleSetup& setup, const LinkPoses& poses, CycleBuffers& buffers) noexcept {
  lookAhead(setup, poses, buffers.body_poses, setup.ahead.horizon, buffers.bounds);
  accumulateTravel(setup, poses, buffers);
  listNear(setup, poses, haveLinksChanged(buffers.body_poses, buffers.memory.last), buffers);
}

/// Measures distances of near pairs, within the budget. @param counts_bodies they take their part
void measureNear(const CycleSetup& setup, const LinkPoses& poses, bool counts_bodies,
                 CycleBuffers& buffers) noexcept {
  findActivationDistances(setup, poses, buffers.robots, buffers.sweep, buffers.activation);
  cullCandidates(setup, poses, buffers);
  measurePairs(setup, buffers.body_poses, buffers.candidates, buffers.distances);
  keepNear(setup, poses, buffers);
  buffers.refine.elapsed = buffers.sweep.elapsed;
  buffers.refine.near_bodies = counts_bodies ? buffers.refine.near_bodies : 0;
  refinePairs(setup, buffers.body_poses, buffers.memory, buffers.refine, buffers.distances);
}

/// Measures all that somebody is told.
void measure(const CycleSetup& setup, const LinkPoses& poses, CycleBuffers& buffers) noexcept {
  measureNear(setup, poses, true, buffers);
  measureDeferred(setup, poses, buffers);
  // Where pairs were passed over, a nearer one was measured, or all are measured once more.
  if (buffers.passed_over == 0) {
    measureClosest(setup, poses, leastActivationDistanceOf(setup), buffers);
  }
  findClosings(setup, poses, buffers.distances);
  measureTold(setup, poses, buffers);
}

/// Measures what is expected to be told; once more if a pair that was passed over may matter.
void measureExpected(const CycleSetup& setup, const LinkPoses& poses,
                     CycleBuffers& buffers) noexcept {
  if (buffers.refine.tells_all) {
    expectNothing(buffers.robots);
  }
  measure(setup, poses, buffers);
  if (isMoreThanExpected(setup, buffers.robots, buffers.events)) {
    expectFound(setup, buffers.robots);
    buffers.refine.work_before = buffers.refine.work_done;
    measure(setup, poses, buffers);
    buffers.refine.work_before = 0;
  }
  keepProven(setup, buffers);
}

}  // namespace

void learnPairs(const CycleSetup& setup, const LinkPoses& poses, CycleBuffers& buffers) noexcept {
  constexpr std::uint32_t kCycles = 50;
  constexpr std::uint32_t kAny = std::numeric_limits<std::uint32_t>::max();
  const std::uint32_t usual = buffers.refine.limits.budget;
  buffers.refine.limits.budget = kCycles * std::min(usual, kAny / kCycles);
  moveAll(setup, buffers.body_poses.moved);
  place(setup, poses, buffers.body_poses);
  list(setup, poses, buffers);
  measureNear(setup, poses, false, buffers);
  measureDeferred(setup, poses, buffers);
  buffers.refine.limits.budget = usual;
}

void prepareFirstCycle(const CycleSetup& setup, const LinkPoses& poses,
                       CycleBuffers& buffers) noexcept {
  learnPairs(setup, poses, buffers);
  runCycle(setup, poses, buffers);
  settleObjects(setup, poses, buffers);
  forgetReported(buffers);
  forgetTold(buffers.events);
}

void runCycle(const CycleSetup& setup, const LinkPoses& poses, CycleBuffers& buffers) noexcept {
  findResting(setup, poses, buffers.memory.last, buffers.body_poses);
  place(setup, poses, buffers.body_poses);
  buffers.memory.judges_all =
      buffers.memory.judges_all || haveLinksChanged(buffers.body_poses, buffers.memory.last);
  findMotions(setup, poses, buffers.body_poses, buffers.memory, buffers.sweep);
  list(setup, poses, buffers);
  measureExpected(setup, poses, buffers);
  if (setup.is_continuous) {
    sweepPairs(setup, buffers.memory.refined, buffers.refine, buffers.sweep, buffers.distances);
  }
  keepPoses(poses, buffers.body_poses, buffers.memory.last);
  judgePairs(setup, buffers.body_poses, poses.velocities, buffers.distances, buffers.memory,
             buffers.events);
  scaleSpeed(setup, poses.stamp_ns, buffers.distances, buffers.events, buffers.memory.reported,
             buffers.memory.speed, buffers.robots);
  if (!buffers.refine.tells_all) {
    expectNext(setup, buffers.robots);
  }
  buffers.counters.measured = buffers.candidates.size() + buffers.deferred.size();
  buffers.counters.refined = buffers.refine.refined;
  buffers.counters.left = buffers.refine.left;
  buffers.counters.refine_work = buffers.refine.work_done;
  buffers.counters.swept = buffers.sweep.swept;
  buffers.counters.swept_left = buffers.sweep.left;
  if (buffers.memory.judges_all) {
    countUnknown(setup, buffers.body_poses, buffers.counters);
  }
  keepLively(setup, buffers.events, buffers.memory);
}

}  // namespace collision_monitor
