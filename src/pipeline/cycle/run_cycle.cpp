// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/cycle/run_cycle.h"

#include <algorithm>

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

/// Boxes of bodies in two parts may meet, which means nothing.
void dropUnjoined(const CycleSetup& setup, const BodyPoses& body_poses,
                  std::vector<PairId>& candidates) noexcept {
  if (!body_poses.is_split) {
    return;
  }
  const auto is_apart = [&](PairId id) {
    const BodyPair& pair = setup.table[id];
    return !isJoined(body_poses, setup.bodies[index(pair.a)].link,
                     setup.bodies[index(pair.b)].link);
  };
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(), is_apart),
                   candidates.end());
}

void place(const CycleSetup& setup, const LinkPoses& poses, BodyPoses& body_poses) noexcept {
  placeBodies(setup, poses, body_poses);
  placeElements(setup, poses, body_poses);
}

/// Distances of what is near, up to what the budget allows.
void measureNear(const CycleSetup& setup, const LinkPoses& poses, CycleBuffers& buffers) noexcept {
  const double reach = reachOf(setup.limits);
  boundBodies(setup, buffers.body_poses, reach, buffers.bounds);
  if (setup.is_continuous) {
    sweepBounds(setup, buffers.body_poses, buffers.sweep, reach, buffers.bounds);
  }
  growBounds(setup, poses, setup.ahead.horizon, buffers.bounds);
  findCandidates(buffers.broad_phase, buffers.bounds, setup.table, buffers.candidates);
  dropUnjoined(setup, buffers.body_poses, buffers.candidates);
  buffers.counters.candidates = buffers.candidates.size();
  findReaches(setup, poses, buffers.sweep, buffers.reaches);
  followWays(setup, poses, buffers);
  cullCandidates(setup, buffers);
  measurePairs(setup, buffers.body_poses, buffers.candidates, buffers.distances);
  keepNear(setup, buffers);
  buffers.refine.elapsed = buffers.sweep.elapsed;
  refinePairs(setup, buffers.body_poses, buffers.memory, buffers.refine, buffers.distances);
}

}  // namespace

CycleBuffers makeBuffers(const CycleSetup& setup, BroadPhaseKind kind) {
  const std::size_t bodies = setup.bodies.size();
  const std::size_t pairs = setup.table.size();
  const std::size_t link_pairs = setup.checked.size();
  const std::size_t links = setup.model.links.size();
  CycleBuffers buffers;
  buffers.body_poses = makeBodyPoses(setup);
  buffers.bounds.boxes.resize(bodies);
  buffers.bounds.known.resize(bodies, 0);
  buffers.bounds.ahead.resize(bodies, 0.0);
  buffers.reaches = makePairReaches(setup);
  buffers.candidates.reserve(pairs);
  buffers.waiting.reserve(pairs);
  buffers.distances.measured.reserve(pairs);
  buffers.distances.passed.reserve(pairs);
  buffers.refine = makeRefineWork(setup);
  buffers.sweep = makeSweepWork(setup);
  buffers.events.verdicts.resize(link_pairs, Verdict::unknown);
  buffers.events.closest.resize(link_pairs, kNone);
  buffers.events.passed.resize(link_pairs, kNone);
  buffers.events.estimated.resize(link_pairs, kNone);
  buffers.events.soonest.resize(link_pairs, kNone);
  buffers.events.changes.reserve(link_pairs);
  buffers.events.island_of_link.resize(links, 0);
  buffers.events.island_forest.resize(links, 0);
  buffers.memory.reported.resize(link_pairs, Verdict::clear);
  buffers.memory.contact_detail.resize(link_pairs, Detail::shapes);
  buffers.memory.refined = makeRefineMemory(setup);
  buffers.memory.waited.resize(setup.element_pairs.size(), 0);
  buffers.memory.gaps = makeKnownGaps(setup);
  buffers.memory.last.world_from_link.resize(links);
  buffers.memory.last.known.resize(links, 0);
  buffers.memory.last.part.resize(links, kWorldPart);
  buffers.memory.speed.stopped.resize(link_pairs, 0);
  buffers.counters.pairs = pairs;
  buffers.broad_phase = makeBroadPhase(kind, bodies, pairs);
  buffers.culls_by_boxes = kind == BroadPhaseKind::combination;
  return buffers;
}

void forgetPoses(CycleBuffers& buffers) noexcept {
  buffers.memory.refined.forgetAll();
  std::fill(buffers.memory.waited.begin(), buffers.memory.waited.end(), 0);
  std::fill(buffers.memory.last.known.begin(), buffers.memory.last.known.end(), 0);
  buffers.memory.last.stamp_ns = 0;
}

void resetMemory(CycleBuffers& buffers) noexcept {
  forgetPoses(buffers);
  std::fill(buffers.memory.reported.begin(), buffers.memory.reported.end(), Verdict::clear);
  std::fill(buffers.memory.contact_detail.begin(), buffers.memory.contact_detail.end(),
            Detail::shapes);
  SpeedScale& speed = buffers.memory.speed;
  std::fill(speed.stopped.begin(), speed.stopped.end(), 0);
  speed.scale = 1.0;
}

double reachOf(const Limits& limits) noexcept {
  return std::max(limits.report_distance, limits.warning_distance + limits.hysteresis);
}

double nearReachOf(const CycleSetup& setup) noexcept {
  return std::max(setup.refine.distance, setup.limits.warning_distance + setup.limits.hysteresis);
}

void learnPairs(const CycleSetup& setup, const LinkPoses& poses, CycleBuffers& buffers) noexcept {
  constexpr int kMost = 50;
  place(setup, poses, buffers.body_poses);
  for (int i = 0; i < kMost; ++i) {
    measureNear(setup, poses, buffers);
    if (buffers.refine.left == 0) {
      return;
    }
  }
}

void runCycle(const CycleSetup& setup, const LinkPoses& poses, CycleBuffers& buffers) noexcept {
  const double reach = reachOf(setup.limits);
  place(setup, poses, buffers.body_poses);
  findMotions(setup, poses, buffers.body_poses, buffers.memory, buffers.sweep);
  measureNear(setup, poses, buffers);
  measureWaiting(setup, buffers);
  measureClosest(setup, buffers.body_poses, buffers.refine, reach, buffers.distances);
  if (setup.is_continuous) {
    sweepPairs(setup, buffers.memory.refined, buffers.refine, buffers.sweep, buffers.distances);
  }
  keepPoses(poses, buffers.body_poses, buffers.memory.last);
  findClosings(setup, poses, buffers.distances);
  judgePairs(setup, buffers.body_poses, poses.velocities, buffers.distances, buffers.memory,
             buffers.events);
  scaleSpeed(setup, poses.stamp_ns, buffers.distances, buffers.events, buffers.memory.speed);
  buffers.counters.measured = buffers.candidates.size() + buffers.waiting.size();
  buffers.counters.refined = buffers.refine.refined;
  buffers.counters.left = buffers.refine.left;
  buffers.counters.refine_steps = buffers.refine.steps;
  buffers.counters.swept = buffers.sweep.swept;
  buffers.counters.swept_left = buffers.sweep.left;
  countUnknown(setup, buffers.body_poses, buffers.counters);
}

}  // namespace collision_monitor
