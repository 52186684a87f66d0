// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/cycle/cycle_buffers.h"

#include <algorithm>

#include "geometry/all_cores.h"
#include "pipeline/cycle/distance_cache.h"
#include "pipeline/cycle/place_bodies.h"
#include "pipeline/look_ahead/link_walk.h"

namespace collision_monitor {

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
  buffers.candidates.reserve(pairs);
  buffers.deferred.reserve(pairs);
  buffers.distances.pairs.reserve(pairs);
  buffers.distances.passed.reserve(pairs);
  buffers.refine = makeRefineWork(setup);
  buffers.sweep = makeSweepWork(setup);
  buffers.events.verdicts.resize(link_pairs, Verdict::unknown);
  buffers.events.closest.resize(link_pairs, kNone);
  buffers.events.passed.resize(link_pairs, kNone);
  buffers.events.estimated.resize(link_pairs, kNone);
  buffers.events.soonest.resize(link_pairs, kNone);
  buffers.events.changes.reserve(link_pairs);
  buffers.events.active.reserve(link_pairs);
  buffers.events.is_active.resize(link_pairs, 0);
  buffers.events.settled.reserve(link_pairs);
  buffers.events.is_settled.resize(link_pairs, 0);
  buffers.events.is_checked.resize(links, 0);
  for (const CheckedLinkPair& pair : setup.checked) {
    buffers.events.is_checked[index(pair.a)] = buffers.events.is_checked[index(pair.b)] = 1;
  }
  buffers.memory.lively.reserve(link_pairs);
  buffers.events.island_of_link.resize(links, 0);
  buffers.events.island_forest.resize(links, 0);
  buffers.events.links_of_islands.reserve(links);
  buffers.memory.reported.resize(link_pairs, Verdict::clear);
  buffers.memory.contact_detail.resize(link_pairs, Detail::shapes);
  buffers.memory.refined = makeRefineMemory(setup);
  buffers.memory.starved_cycles.resize(setup.element_pairs.size(), 0);
  buffers.memory.distance_cache = makeDistanceCache(setup);
  buffers.memory.last.world_from_link.resize(links);
  buffers.memory.last.known.resize(links, 0);
  buffers.memory.last.part.resize(links, kWorldPart);
  buffers.memory.last.rests.resize(setup.carried.size());
  buffers.memory.speed.stopped.resize(link_pairs, 0);
  buffers.robots = makeRobotSpeeds(setup.model);
  buffers.counters.pairs = pairs;
  constexpr std::size_t kManyPairs = 50'000;
  doBoth(
      pairs >= kManyPairs, [&] { buffers.activation = makeActivationDistances(setup); },
      [&] { buffers.trees = makeObjectTrees(setup, kind); });
  buffers.broad_phase = buffers.trees.trees.empty()
                            ? makeBroadPhase(kind, bodies, pairs)
                            : makeBroadPhase(kind, buffers.trees.loose.size(), pairs);
  buffers.culls_by_boxes = kind == BroadPhaseKind::combination;
  return buffers;
}

void forgetPoses(CycleBuffers& buffers) noexcept {
  buffers.memory.refined.forgetAll();
  std::fill(buffers.memory.starved_cycles.begin(), buffers.memory.starved_cycles.end(), 0);
  LastPoses& last = buffers.memory.last;
  std::vector<unsigned char>& placed = buffers.memory.distance_cache.placed.known;
  std::fill(last.known.begin(), last.known.end(), 0);
  std::fill(placed.begin(), placed.end(), 0);
  std::fill(last.rests.begin(), last.rests.end(), Rest());
  last.stamp_ns = 0;
  std::fill(buffers.sweep.has_motion.begin(), buffers.sweep.has_motion.end(), 0);
  std::fill(buffers.sweep.had_motion.begin(), buffers.sweep.had_motion.end(), 0);
}

void forgetReported(CycleBuffers& buffers) noexcept {
  std::fill(buffers.memory.reported.begin(), buffers.memory.reported.end(), Verdict::clear);
  std::fill(buffers.memory.contact_detail.begin(), buffers.memory.contact_detail.end(),
            Detail::shapes);
  SpeedScale& speed = buffers.memory.speed;
  std::fill(speed.stopped.begin(), speed.stopped.end(), 0);
  speed.scale = 1.0;
  std::fill(buffers.robots.scales.begin(), buffers.robots.scales.end(), 1.0);
}

void resetMemory(CycleBuffers& buffers) noexcept {
  forgetPoses(buffers);
  forgetReported(buffers);
  buffers.memory.judges_all = true;
}

}  // namespace collision_monitor
