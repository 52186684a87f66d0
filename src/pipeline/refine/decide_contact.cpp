// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/refine/decide_contact.h"

#include <algorithm>
#include <vector>

#include "pipeline/refine/touch_elements.h"

namespace collision_monitor {
namespace {

/// Keeps `apart` as a lower bound where nothing better is known.
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

bool isBound(const ElementDistance& known) noexcept {
  return known.quality == Quality::lower_bound;
}

/// Sets RefineTask::touches for the cutoff.
/// @return whether nothing is left to decide: the elements are proven to be beyond the cutoff
/// (which is kept), are measured, or the budget is spent.
bool tryDecide(const Refinement& all, RefineTask& task, const ElementDistance& recalled,
               const Goal& goal) noexcept {
  constexpr std::uint32_t kMostHard = 8;  // a pair that is hard to decide leaves budget to others
  task.touches = false;
  const bool is_apart = isBound(recalled) && recalled.measured.distance >= goal.cutoff;
  if (is_apart || reachesCutoff(recalled, goal.cutoff) || !(all.work.work_done < goal.budget)) {
    return true;
  }
  const ElementPair& pair = all.setup.element_pairs[task.pair];
  ElementSearch search = searchFor(all, task, goal);
  search.budget = std::min(search.budget, budgetOf(all) / kMostHard);
  const bool is_still_outside = isBound(recalled) && recalled.measured.distance > 0.0;
  const ElementContact contact =
      touchElements(placed(all, pair.a), placed(all, pair.b),
                    {goal.cutoff, true, is_still_outside ? recalled.outside : 0.0}, search);
  spend(all, task, contact.work);
  task.touches = contact.state == ElementContact::State::contact;
  if (contact.state == ElementContact::State::apart) {
    keepApart(all, task, goal.cutoff, contact);
  }
  return contact.state == ElementContact::State::apart;
}

/// Whether the last bound still excludes a contact, and half of it is left. A contact that is
/// reported ends at the whole cutoff only.
bool isDecided(const Refinement& all, const RefineTask& task, const ElementDistance& recalled,
               double cutoff) noexcept {
  const double contact = std::max(0.0, limitsOf(all, task).contact_distance);
  const std::vector<Verdict>& reported = all.memory.reported;  // none where nothing is reported
  const std::uint32_t link_pair = all.setup.element_pairs[task.pair].link_pair;
  return !reported.empty() && reported[link_pair] != Verdict::contact && isBound(recalled) &&
         recalled.measured.distance > 0.5 * (contact + cutoff);
}

/// Whether measured elements have moved so little since that following them takes less work than
/// deciding anew.
bool isFollowed(const ElementDistance& last, const ElementDistance& recalled,
                double little) noexcept {
  return last.has_points && last.quality != Quality::estimate &&
         last.measured.distance - recalled.measured.distance < little;
}

/// Whether the elements are proven to overlap still. A point inside a closed surface leaves it only
/// through the surface, so a motion less than its depth does not bring it out. An open surface may
/// let it out through a hole.
bool isHeld(const Refinement& all, const RefineTask& task) noexcept {
  const auto is_solid = [](const PlacedElement& placed) {
    return !placed.element.mesh || placed.element.mesh->isClosed();
  };
  const ElementPair& pair = all.setup.element_pairs[task.pair];
  const PlacedElement a = placed(all, pair.a);
  const PlacedElement b = placed(all, pair.b);
  return is_solid(a) && is_solid(b) &&
         recallOverlap(all.memory.refined.lastOf(task.pair), a, b, ballsOf(all, pair));
}

}  // namespace

void decideContact(const Refinement& all, RefineTask& task) noexcept {
  constexpr double kPastThreshold = 1e-6;
  const Goal clear{clearBeyond(all, task), budgetOf(all) / 4 * 3};
  if (task.bound > clear.cutoff) {
    return;
  }
  const ElementDistance& last = all.memory.refined.lastOf(task.pair).found;
  const ElementDistance recalled = recallTask(all, task);
  const bool has_overlapped = last.quality == Quality::estimate;
  const double contact = std::max(0.0, limitsOf(all, task).contact_distance);
  if (isDecided(all, task, recalled, clear.cutoff)) {
    return;
  }
  if (has_overlapped && isHeld(all, task)) {
    task.touches = true;
    return;
  }
  if (isFollowed(last, recalled, clear.cutoff)) {
    task.may_touch = !(recalled.measured.distance > contact + kPastThreshold);
    return;
  }
  if (!has_overlapped && tryDecide(all, task, recalled, clear)) {
    return;
  }
  tryDecide(all, task, recalled, {contact + kPastThreshold, clear.budget});
}

}  // namespace collision_monitor
