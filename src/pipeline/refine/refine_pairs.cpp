// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/refine/refine_pairs.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "geometry/constants.h"
#include "pipeline/blocks/contact_of_pairs.h"
#include "pipeline/refine/decide_contact.h"
#include "pipeline/refine/deepen_overlaps.h"
#include "pipeline/refine/refine_tasks.h"
#include "pipeline/refine/refinement.h"

namespace collision_monitor {
namespace {

/// Raises a distance to a larger proven bound; its point on B follows along the normal.
void raiseBound(double bound, PairDistance& distance) noexcept {
  SignedDistance& measured = distance.measured;
  if (bound > measured.distance) {
    measured.distance = bound;
    measured.point_on_b = measured.point_on_a + bound * measured.normal_a_to_b;
    distance.is_raised = true;
  }
}

/// @param contact [m] contactOfElements: a bound at or below it does not exclude a contact.
void takeOver(const ElementDistance& found, double contact, PairDistance& distance) noexcept {
  const bool is_nearer = found.has_points ? !(found.measured.distance >= distance.measured.distance)
                                          : !(found.measured.distance > distance.measured.distance);
  // Shapes that overlap give the depth of one pair of shapes: it does not bound the elements'.
  const bool is_depth = found.has_points && distance.measured.distance < 0.0;
  if (found.quality == Quality::unknown ||
      (found.quality == Quality::lower_bound && is_nearer && !is_depth)) {
    return;  // the enclosing shapes give the better bound
  }
  if (found.has_points) {
    distance.quality = found.quality;
    distance.measured = found.measured;
    distance.is_refined = true;
  } else if (found.quality != Quality::lower_bound || found.measured.distance > contact) {
    distance.quality = found.quality;
    raiseBound(found.measured.distance, distance);
  }
}

/// [m] Beyond this a pair is not the nearest of its links, or nobody asks for its distance.
double farthestAsked(const Refinement& all, const RefineTask& task) noexcept {
  const std::uint32_t link_pair = all.setup.element_pairs[task.pair].link_pair;
  return std::min(all.work.nearest[link_pair], all.work.cutoff);
}

/// Whether the distance of the pair is not asked for and the pair is in no contact.
bool isSettled(const Refinement& all, const RefineTask& task) noexcept {
  const Limits& limits = limitsOf(all, task);
  return task.bound > farthestAsked(all, task) &&
         task.bound > std::max(0.0, limits.contact_distance + limits.hysteresis);
}

/// [m] Beyond this the distance of the pair is not asked for and the pair is in no contact.
double cutoffFor(const Refinement& all, const RefineTask& task) noexcept {
  return std::max(farthestAsked(all, task), clearBeyond(all, task));
}

/// Whether a threshold of verdicts lies within the tolerance of a distance.
bool isAtThreshold(const Refinement& all, const RefineTask& task,
                   const ElementDistance& found) noexcept {
  const Limits& limits = limitsOf(all, task);
  if (!found.has_points || found.quality == Quality::estimate) {
    return false;
  }
  const double least = found.measured.distance;
  const auto holds = [&](double threshold) {
    return least <= threshold && threshold < least + all.work.limits.tolerance;
  };
  return holds(limits.contact_distance) || holds(limits.contact_distance + limits.hysteresis) ||
         holds(limits.warning_distance) || holds(limits.warning_distance + limits.hysteresis);
}

/// Measures within the tolerance, and exactly where a verdict depends on it. The result is not
/// complete until the exact search is done.
ElementDistance measureForVerdict(const Refinement& all, RefineTask& task, const Goal& goal,
                                  ElementSearch& search) noexcept {
  const ElementPair& pair = all.setup.element_pairs[task.pair];
  ElementDistance found = measureElements(placed(all, pair.a), placed(all, pair.b), search);
  spend(all, task, found.work);
  if (!isAtThreshold(all, task, found)) {
    return found;
  }
  found.is_complete = false;
  if (all.work.work_done < goal.budget) {
    ElementSearch exactly = searchFor(all, task, goal);
    exactly.tolerance = 0.0;
    const ElementDistance exact =
        measureElements(placed(all, pair.a), placed(all, pair.b), exactly);
    spend(all, task, exact.work);
    found = exact.is_complete ? exact : found;
  }
  return found;
}

ElementDistance measureTask(const Refinement& all, RefineTask& task, const Goal& goal,
                            const ElementDistance& recalled) noexcept {
  const ElementPair& pair = all.setup.element_pairs[task.pair];
  ElementSearch search = searchFor(all, task, goal);
  ElementDistance found = measureForVerdict(all, task, goal, search);
  if (!found.has_points && !found.is_complete && recalled.quality == Quality::lower_bound &&
      !(recalled.measured.distance < found.measured.distance)) {
    found.quality = Quality::lower_bound;
    found.measured.distance = recalled.measured.distance;
  }
  remember({found, placed(all, pair.a).world_from_element, placed(all, pair.b).world_from_element},
           search.memory);
  return found;
}

void report(const Refinement& all, RefineTask& task, const ElementDistance& found) noexcept {
  RefineWork& work = all.work;
  task.outside = found.outside;
  PairDistance& distance = all.distances.pairs[task.place];
  takeOver(found, contactOfElements(all.setup, task.pair), distance);
  // A measured depth has no shortfall, a kept one has.
  const bool is_short =
      found.shortfall > (found.quality == Quality::estimate ? 0.0 : work.limits.tolerance);
  distance.shortfall =
      is_short ? found.measured.distance + found.shortfall - distance.measured.distance : 0.0;
  work.is_measured[task.pair] = 1;
  ++(found.is_complete ? work.refined : work.left);
  if (found.is_complete) {
    double& nearest = work.nearest[all.setup.element_pairs[task.pair].link_pair];
    nearest = std::min(nearest, distance.measured.distance + distance.shortfall);
    if (work.finds_nearest && !distance.is_raised) {
      work.cutoff = std::min(work.cutoff, distance.measured.distance);
    }
  }
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

/// The recalled measurement. It has points where they are within the tolerance, or where the
/// distance need not be measured.
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

void measureFully(const CycleSetup& setup, const BodyPoses& body_poses, PairMemory& memory,
                  std::uint32_t place, RefineWork& work, PairDistances& distances) noexcept {
  constexpr double kPastBound = 1e-6;
  const Refinement all{setup, body_poses, memory, work, distances};
  RefineTask& task =
      work.tasks[work.task_of[setup.element_pair_of[index(distances.pairs[place].pair)]]];
  // Beyond its own upper bound, at which its points may still be the nearest.
  const PairDistance& bounds = distances.pairs[place];
  const double beyond = bounds.measured.distance + bounds.shortfall + kPastBound;
  const Goal goal{std::max(cutoffFor(all, task), beyond), budgetOf(all)};
  if (work.work_done < goal.budget) {
    const ElementDistance found = measureTask(all, task, goal, recallTask(all, task));
    if (found.has_points || found.is_complete) {
      task.place = place;
      --work.refined;  // `report` counts the pair once more
      report(all, task, found);
      deepenOverlap(all, task, goal.budget);
      return;
    }
  }
  ++memory.starved_cycles[task.pair];  // its bounds stay
}

}  // namespace collision_monitor
