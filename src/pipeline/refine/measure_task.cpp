// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/refine/measure_task.h"

#include <algorithm>

#include "pipeline/blocks/contact_of_pairs.h"

namespace collision_monitor {
namespace {

/// @param contact [m] contactOfElements: a bound at or below it does not exclude a contact.
void takeOver(const ElementDistance& found, double contact, PairDistance& distance) noexcept {
  constexpr double kRounding = 1e-9;  // [m] between the bound and the distance it came from
  const double bound = distance.measured.distance;
  const bool is_nearer = found.has_points ? !(found.measured.distance >= bound - kRounding)
                                          : !(found.measured.distance > bound);
  // Shapes that overlap give the depth of one pair of shapes: it does not bound the elements'.
  const bool is_depth = found.has_points && bound < 0.0;
  if (found.quality == Quality::unknown ||
      (found.quality == Quality::lower_bound && is_nearer && !is_depth)) {
    return;  // the enclosing shapes give the better bound
  }
  if (found.has_points) {
    distance.quality = found.quality;
    distance.measured = found.measured;
    distance.is_refined = true;
    distance.is_raised = false;
  } else if (found.quality != Quality::lower_bound || found.measured.distance > contact) {
    distance.quality = found.quality;
    raiseBound(found.measured.distance, distance);
  }
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

}  // namespace

void raiseBound(double bound, PairDistance& distance) noexcept {
  SignedDistance& measured = distance.measured;
  if (bound > measured.distance) {
    measured.distance = bound;
    measured.point_on_b = measured.point_on_a + bound * measured.normal_a_to_b;
    distance.is_raised = true;
  }
}

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

}  // namespace collision_monitor
