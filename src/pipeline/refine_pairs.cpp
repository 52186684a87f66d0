// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/pipeline/refine_pairs.h"

#include <algorithm>
#include <limits>

#include "geometry/constants.h"
#include "pipeline/recall_elements.h"
#include "pipeline/refine_tasks.h"
#include "pipeline/touch_elements.h"

namespace collision_monitor {
namespace {

/// What every step needs.
struct Refinement {
  const CycleSetup& setup;
  const BodyPoses& body_poses;
  PairMemory& memory;
  RefineWork& work;
  PairDistances& distances;
};

/// Of steps. A part is kept for what happens between two cycles.
std::uint32_t budgetOf(const Refinement& all) noexcept {
  const std::uint32_t budget = all.work.limits.budget;
  return all.setup.is_continuous ? budget - budget / 4 : budget;
}

/// Where a proven bound without points is larger, the points follow it along the normal.
void raiseBound(double bound, PairDistance& distance) noexcept {
  SignedDistance& measured = distance.measured;
  if (bound > measured.distance) {
    measured.distance = bound;
    measured.point_on_b = measured.point_on_a + bound * measured.normal_a_to_b;
    distance.is_raised = true;
  }
}

void takeOver(const ElementDistance& found, PairDistance& distance) noexcept {
  const bool is_nearer = !(found.measured.distance > distance.measured.distance);
  // Where shapes overlap, theirs is the depth of two of several shapes, which bounds nothing.
  const bool is_depth = found.has_points && distance.measured.distance < 0.0;
  if (found.quality == Quality::unknown ||
      (found.quality == Quality::lower_bound && is_nearer && !is_depth)) {
    return;  // the enclosing shapes know better
  }
  distance.quality = found.quality;
  if (found.has_points) {
    distance.measured = found.measured;
    distance.is_refined = true;
  } else {
    raiseBound(found.measured.distance, distance);
  }
}

/// Whether the pair is farther than what its links are known to be, and in no contact. Bodies that
/// overlap do not tell how deep their elements do.
bool isSettled(const Refinement& all, const RefineTask& task) noexcept {
  const Limits& limits = all.setup.limits;
  return task.bound > all.work.nearest[all.setup.element_pairs[task.pair].link_pair] &&
         task.bound > std::max(0.0, limits.contact_distance + limits.hysteresis);
}

PlacedElement placed(const Refinement& all, ElementId id) noexcept {
  return {all.setup.elements[index(id)], all.body_poses.world_from_element[index(id)]};
}

/// Beyond this a pair is in no contact.
double clearBeyond(const Refinement& all) noexcept {
  constexpr double kNotTouching = 1e-3;
  constexpr double kPastThreshold = 1e-6;  // a contact is held at its threshold, which is enough
  const Limits& limits = all.setup.limits;
  return std::max(limits.contact_distance + limits.hysteresis + kPastThreshold, kNotTouching);
}

/// Beyond this a pair is not the nearest of its links, and in no contact.
double enoughFor(const Refinement& all, const RefineTask& task) noexcept {
  const std::uint32_t link_pair = all.setup.element_pairs[task.pair].link_pair;
  return std::max(all.work.nearest[link_pair], clearBeyond(all));
}

/// How far searches go.
struct Goal {
  double enough;         ///< [m] how far elements are apart need not be known beyond
  std::uint32_t budget;  ///< of all steps of the cycle
};

ElementSearch searchFor(const Refinement& all, const RefineTask& task, const Goal& goal) noexcept {
  return {goal.budget - static_cast<std::uint32_t>(all.work.steps),
          all.memory.refined.of(task.pair), *all.work.scratch, goal.enough,
          all.work.limits.tolerance};
}

ElementDistance recallTask(const Refinement& all, const RefineTask& task) noexcept {
  const ElementPair& pair = all.setup.element_pairs[task.pair];
  return recallElements(all.memory.refined.lastOf(task.pair), placed(all, pair.a),
                        placed(all, pair.b),
                        {all.work.balls[index(pair.a)], all.work.balls[index(pair.b)]});
}

/// Whether there is nothing left to find nearer than `enough`.
bool isEnough(const ElementDistance& found, double enough) noexcept {
  return found.is_complete && (found.has_points || found.quality != Quality::lower_bound ||
                               found.measured.distance >= enough);
}

ElementDistance measureTask(const Refinement& all, const RefineTask& task, const Goal& goal,
                            const ElementDistance& recalled) noexcept {
  const ElementPair& pair = all.setup.element_pairs[task.pair];
  const PlacedElement a = placed(all, pair.a);
  const PlacedElement b = placed(all, pair.b);
  ElementSearch search = searchFor(all, task, goal);
  ElementDistance found = measureElements(a, b, search);
  all.work.steps += found.steps;
  if (!found.is_complete && recalled.quality == Quality::lower_bound &&
      !(recalled.measured.distance < found.measured.distance)) {
    found.quality = Quality::lower_bound;
    found.measured.distance = recalled.measured.distance;
  }
  remember({found, a.world_from_element, b.world_from_element}, search.memory);
  return found;
}

void report(const Refinement& all, RefineTask& task, const ElementDistance& found) noexcept {
  RefineWork& work = all.work;
  task.outside = found.outside;
  PairDistance& distance = all.distances.measured[task.place];
  takeOver(found, distance);
  work.is_measured[task.pair] = 1;
  ++(found.is_complete ? work.refined : work.left);
  if (found.is_complete) {
    double& nearest = work.nearest[all.setup.element_pairs[task.pair].link_pair];
    nearest = std::min(nearest, distance.measured.distance);
  }
}

/// Keeps that the elements are so far apart at least, where nothing better is known.
void keepApart(const Refinement& all, const RefineTask& task, double apart,
               const ElementContact& contact) noexcept {
  const ElementPair& pair = all.setup.element_pairs[task.pair];
  ElementDistance found;
  found.quality = Quality::lower_bound;
  found.measured.distance = apart;
  found.is_complete = true;
  found.outside = contact.outside;
  remember({found, placed(all, pair.a).world_from_element, placed(all, pair.b).world_from_element},
           all.memory.refined.of(task.pair));
}

/// @return whether nothing is left to decide: they are farther apart, which is kept, or were
/// measured, or the budget is spent.
bool tryDecide(const Refinement& all, const RefineTask& task, const ElementDistance& recalled,
               const Goal& goal) noexcept {
  const bool is_apart =
      recalled.quality == Quality::lower_bound && recalled.measured.distance >= goal.enough;
  if (is_apart || isEnough(recalled, goal.enough) || !(all.work.steps < goal.budget)) {
    return true;
  }
  const ElementPair& pair = all.setup.element_pairs[task.pair];
  ElementSearch search = searchFor(all, task, goal);
  const ElementContact contact =
      touchElements(placed(all, pair.a), placed(all, pair.b), {goal.enough, true}, search);
  all.work.steps += contact.steps;
  if (contact.state == ElementContact::State::apart) {
    keepApart(all, task, goal.enough, contact);
  }
  return contact.state == ElementContact::State::apart;
}

/// Whether elements that were measured have come so little farther since that to follow them takes
/// less than to decide anything anew.
bool isFollowed(const ElementDistance& last, const ElementDistance& recalled,
                double little) noexcept {
  return last.has_points && last.quality != Quality::estimate &&
         last.measured.distance - recalled.measured.distance < little;
}

/// Tells contacts of enclosing shapes that are none of the geometries, and no more: whether
/// geometries touch takes a part of the steps of their distance. First whether they are so far
/// apart that no contact is held, unless they overlapped in the last cycle; then whether they
/// touch. Leaves a part of the budget for distances, so that every pair has its turn.
void decideContact(const Refinement& all, const RefineTask& task) noexcept {
  constexpr double kPastThreshold = 1e-6;
  constexpr double kLittle = 1.0;  // of how far no contact is held
  const Goal clear{clearBeyond(all), budgetOf(all) / 4 * 3};
  if (task.bound > clear.enough) {
    return;
  }
  const ElementDistance& last = all.memory.refined.lastOf(task.pair).found;
  const ElementDistance recalled = recallTask(all, task);
  const bool has_overlapped = last.quality == Quality::estimate;
  if (isFollowed(last, recalled, kLittle * clear.enough) ||
      (!has_overlapped && tryDecide(all, task, recalled, clear))) {
    return;
  }
  const double contact = std::max(0.0, all.setup.limits.contact_distance);
  tryDecide(all, task, recalled, {contact + kPastThreshold, clear.budget});
}

void refine(const Refinement& all, RefineTask& task) noexcept {
  std::uint32_t& waited = all.memory.waited[task.pair];
  const Goal goal{enoughFor(all, task), budgetOf(all)};
  ElementDistance found = recallTask(all, task);
  if (isEnough(found, goal.enough)) {
    waited = 0;
  } else if (all.work.steps < goal.budget) {
    waited = 0;
    found = measureTask(all, task, goal, found);
  } else {
    ++waited;
    found.is_complete = false;
    if (found.quality == Quality::unknown) {
      ++all.work.left;
      return;
    }
  }
  report(all, task, found);
}

bool isOverlap(const Refinement& all, const RefineTask& task) noexcept {
  return all.work.is_measured[task.pair] != 0 &&
         all.distances.measured[task.place].quality == Quality::estimate;
}

/// Depths of what overlaps change no verdict, so they come last and take what is left. A cycle
/// looks at some points, and at a few of each pair at least: the rest has its turn in the next.
void deepenOverlaps(const Refinement& all) noexcept {
  constexpr std::uint32_t kMostPoints = 24;
  constexpr std::uint32_t kFewestPoints = 2;
  RefineWork& work = all.work;
  const auto overlaps = static_cast<std::uint32_t>(
      std::count_if(work.tasks.begin(), work.tasks.end(),
                    [&](const RefineTask& task) { return isOverlap(all, task); }));
  for (const RefineTask& task : work.tasks) {
    if (isOverlap(all, task) && work.steps < budgetOf(all)) {
      const ElementPair& pair = all.setup.element_pairs[task.pair];
      ElementSearch search = searchFor(all, task, {0.0, budgetOf(all)});
      work.steps += deepenElements(placed(all, pair.a), placed(all, pair.b),
                                   std::max(kFewestPoints, kMostPoints / overlaps), search,
                                   all.distances.measured[task.place].measured);
    }
  }
}

/// Leaves of every pair of elements that was measured the entry of its nearest bodies.
void dropFarther(const Refinement& all) noexcept {
  auto& measured = all.distances.measured;
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
  for (const RefineTask& task : work.tasks) {
    decideContact(all, task);
  }
  for (RefineTask& task : work.tasks) {
    if (isSettled(all, task)) {
      memory.waited[task.pair] = 0;
    } else {
      refine(all, task);
    }
  }
  deepenOverlaps(all);
  dropFarther(all);
}

}  // namespace collision_monitor
