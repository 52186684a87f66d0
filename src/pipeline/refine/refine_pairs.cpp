// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/refine/refine_pairs.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "geometry/constants.h"
#include "pipeline/refine/decide_contact.h"
#include "pipeline/refine/deepen_overlaps.h"
#include "pipeline/refine/measure_task.h"
#include "pipeline/refine/refine_tasks.h"
#include "pipeline/refine/refinement.h"

namespace collision_monitor {
namespace {

/// Whether the distance of the pair is not asked for and the pair is in no contact.
bool isSettled(const Refinement& all, const RefineTask& task) noexcept {
  const Limits& limits = limitsOf(all, task);
  return task.bound > farthestAsked(all, task) &&
         task.bound > std::max(0.0, limits.contact_distance + limits.hysteresis);
}

/// The depth of a contact that stays one, where it need not be measured.
std::optional<ElementDistance> keepDepth(const Refinement& all, const RefineTask& task) noexcept {
  const ElementPair& pair = all.setup.element_pairs[task.pair];
  const bool may_wait = !all.work.tells_all && task.starved_cycles == 0 && task.touches;
  // An open mesh that touches within a distance need not overlap.
  const bool overlaps = !(limitsOf(all, task).contact_distance > 0.0);
  return may_wait && overlaps && all.memory.reported[pair.link_pair] == Verdict::contact
             ? recallOverlap(all.memory.refined.lastOf(task.pair), placed(all, pair.a),
                             placed(all, pair.b), ballsOf(all, pair))
             : std::nullopt;
}

/// What the last measurement tells of the pair now. It has points if these show the distance within
/// the tolerance, or if nobody is told the distance.
ElementDistance recallToCutoff(const Refinement& all, const RefineTask& task) noexcept {
  const ElementPair& pair = all.setup.element_pairs[task.pair];
  if (const std::optional<ElementDistance> kept = keepDepth(all, task)) {
    return *kept;
  }
  ElementDistance recalled = recallTask(all, task);
  if (recalled.has_points) {
    return recalled;
  }
  const bool may_wait = !all.work.tells_all && task.starved_cycles == 0;
  const bool is_bound = recalled.quality == Quality::lower_bound;
  const double moved = is_bound ? recalled.measured.distance : 0.0;
  std::optional<ElementDistance> points =
      recallPoints(all.memory.refined.lastOf(task.pair).witness, placed(all, pair.a),
                   placed(all, pair.b), may_wait ? std::max(moved, task.bound) : moved);
  if (!points) {
    return recalled;
  }
  points->outside = is_bound ? std::max(recalled.outside, task.bound) : task.bound;
  if (points->shortfall <= all.work.limits.tolerance) {
    // Only those of the last measurement say how fast the elements close.
    const bool are_last = all.memory.refined.lastOf(task.pair).found.has_points;
    const bool is_measured = are_last && !(points->measured.distance > moved);
    return is_measured && !isAtThreshold(all, task, *points) ? *points : recalled;
  }
  points->quality = Quality::lower_bound;
  return may_wait ? *points : recalled;
}

void refine(const Refinement& all, RefineTask& task) noexcept {
  std::uint32_t& starved_cycles = all.memory.starved_cycles[task.pair];
  const Goal goal{cutoffFor(all, task), shareOf(all)};
  ElementDistance found = recallToCutoff(all, task);
  if (reachesCutoff(found, goal.cutoff)) {
    starved_cycles = 0;
  } else if (all.work.work_done < goal.budget) {
    starved_cycles = 0;
    found = measureTask(all, task, goal, found);
  } else {
    ++starved_cycles;
    found.is_complete = false;
    if (found.quality == Quality::unknown) {
      ++all.work.left;
      return;
    }
  }
  report(all, task, found);
}

/// Measures what may touch before others use up the budget.
void refineTouching(const Refinement& all) noexcept {
  for (RefineTask& task : all.work.tasks) {
    if (task.may_touch) {
      refine(all, task);
    }
  }
}

void refineTasks(const Refinement& all) noexcept {
  constexpr std::size_t kAhead = 3;
  constexpr std::size_t kLine = 64;
  std::vector<RefineTask>& tasks = all.work.tasks;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    // Memories are far apart: that of a later task is on its way while this one is refined.
    const RefineTask& later = tasks[std::min(i + kAhead, tasks.size() - 1)];
    const LastMeasurement& last = all.memory.refined.lastOf(later.pair);
    for (std::size_t byte = 0; byte < sizeof(last); byte += kLine) {
      __builtin_prefetch(reinterpret_cast<const char*>(&last) + byte);
    }
    if (tasks[i].may_touch) {
      continue;
    }
    if (isSettled(all, tasks[i])) {
      all.memory.starved_cycles[tasks[i].pair] = 0;
    } else {
      refine(all, tasks[i]);
    }
  }
}

/// Keeps one entry for each measured pair of elements, that of its nearest bodies.
void dropFarther(const Refinement& all) noexcept {
  auto& measured = all.distances.pairs;
  std::size_t kept = 0;
  for (std::uint32_t i = 0; i < measured.size(); ++i) {
    const ElementPairIndex pair = all.setup.element_pair_of[index(measured[i].pair)];
    if (all.work.is_measured[pair] == 0 || all.work.tasks[all.work.task_of[pair]].place == i) {
      measured[kept++] = measured[i];
    }
  }
  measured.resize(kept);
}

}  // namespace

void refinePairs(const CycleSetup& setup, const BodyPoses& body_poses, PairMemory& memory,
                 RefineWork& work, PairDistances& distances) noexcept {
  const Refinement all{setup, body_poses, memory, work, distances};
  listTasks(setup, memory, distances, work);
  for (RefineTask& task : work.tasks) {
    decideContact(all, task);
  }
  refineTouching(all);
  refineTasks(all);
  deepenOverlaps(all);
  dropFarther(all);
}

}  // namespace collision_monitor
