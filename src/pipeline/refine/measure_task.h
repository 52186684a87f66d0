// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "pipeline/refine/refinement.h"

namespace collision_monitor {

/// [m] Beyond this a pair is not the nearest of its links, or nobody asks for its distance.
inline double farthestAsked(const Refinement& all, const RefineTask& task) noexcept {
  const std::uint32_t link_pair = all.setup.element_pairs[task.pair].link_pair;
  return std::min(all.work.nearest[link_pair], all.work.cutoff);
}

/// [m] Beyond this the distance of the pair is not asked for and the pair is in no contact.
inline double cutoffFor(const Refinement& all, const RefineTask& task) noexcept {
  return std::max(farthestAsked(all, task), clearBeyond(all, task));
}

/// Whether a threshold of verdicts lies within the tolerance of a distance.
bool isAtThreshold(const Refinement& all, const RefineTask& task,
                   const ElementDistance& found) noexcept;

/// Measures elements within the tolerance, and exactly where a verdict depends on it.
/// @param recalled what is known of the distance if the budget ends before
ElementDistance measureTask(const Refinement& all, RefineTask& task, const Goal& goal,
                            const ElementDistance& recalled) noexcept;

/// Raises a distance to a larger proven bound; its point on B follows along the normal.
void raiseBound(double bound, PairDistance& distance) noexcept;

/// Writes what was found of elements into their entry.
void report(const Refinement& all, RefineTask& task, const ElementDistance& found) noexcept;

}  // namespace collision_monitor
