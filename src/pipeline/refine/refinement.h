// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "pipeline/refine/recall_elements.h"
#include "pipeline/refine/refine_pairs.h"

/// What the stages of refinePairs share.
namespace collision_monitor {

/// The arguments of refinePairs.
struct Refinement {
  const CycleSetup& setup;
  const BodyPoses& body_poses;
  PairMemory& memory;
  RefineWork& work;
  PairDistances& distances;
};

/// The work for refinePairs. A continuous set-up keeps a quarter for sweepPairs.
inline std::uint32_t budgetOf(const Refinement& all) noexcept {
  const std::uint32_t budget = budgetOf(all.work);
  return all.setup.is_continuous ? budget - budget / 4 : budget;
}

/// As budgetOf, but a quarter less if measureFully follows.
inline std::uint32_t shareOf(const Refinement& all) noexcept {
  const std::uint32_t budget = budgetOf(all);
  return all.work.tells_all ? budget : budget - budget / 4;
}

inline PlacedElement placed(const Refinement& all, ElementId id) noexcept {
  return {all.setup.elements[index(id)], all.body_poses.world_from_element[index(id)]};
}

inline const Limits& limitsOf(const Refinement& all, const RefineTask& task) noexcept {
  return limitsOf(all.setup, all.setup.element_pairs[task.pair].link_pair);
}

/// [m] Beyond this a pair is in no contact.
inline double clearBeyond(const Limits& limits) noexcept {
  constexpr double kNotTouching = 1e-3;
  constexpr double kPastThreshold = 1e-6;  // a contact is held at its threshold itself
  return std::max(limits.contact_distance + limits.hysteresis + kPastThreshold, kNotTouching);
}

inline double clearBeyond(const Refinement& all, const RefineTask& task) noexcept {
  return clearBeyond(limitsOf(all, task));
}

/// How far a search goes.
struct Goal {
  double cutoff;         ///< [m] beyond it a distance need not be known
  std::uint32_t budget;  ///< the work of the whole cycle
};

inline ElementSearch searchFor(const Refinement& all, const RefineTask& task,
                               const Goal& goal) noexcept {
  return {goal.budget - static_cast<std::uint32_t>(all.work.work_done),
          all.memory.refined.of(task.pair), *all.work.scratch, goal.cutoff,
          all.work.limits.tolerance};
}

/// Counts work that was done for a pair.
inline void spend(const Refinement& all, RefineTask& task, std::uint32_t work) noexcept {
  all.work.work_done += work;
  task.work += work;
}

inline std::array<Ball, 2> ballsOf(const Refinement& all, const ElementPair& pair) noexcept {
  return {all.work.balls[index(pair.a)], all.work.balls[index(pair.b)]};
}

inline ElementDistance recallTask(const Refinement& all, const RefineTask& task) noexcept {
  const ElementPair& pair = all.setup.element_pairs[task.pair];
  return recallElements(all.memory.refined.lastOf(task.pair), placed(all, pair.a),
                        placed(all, pair.b), ballsOf(all, pair));
}

/// Whether nothing nearer than the cutoff is left to find.
inline bool reachesCutoff(const ElementDistance& found, double cutoff) noexcept {
  return found.is_complete && (found.has_points || found.quality != Quality::lower_bound ||
                               found.measured.distance >= cutoff);
}

}  // namespace collision_monitor
