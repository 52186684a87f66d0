// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "pipeline/cycle/run_cycle.h"

namespace collision_monitor {

/// How near bodies must be to matter, one pair after the other.
struct NearBodies {
  const CycleSetup& setup;
  const PairReaches& reaches;
  const KnownGaps& gaps;
  double least;  ///< [m] as nearReachOf
  double reach;  ///< [m] as reachOf

  /// [m] No farther apart, bodies matter whatever other bodies of their elements do: by what both
  /// links may close, or by what both bodies may.
  double nearOf(PairId id) const noexcept {
    const BodyPair& pair = setup.table[id];
    const double ahead = gaps.ways[index(pair.a)].ahead + gaps.ways[index(pair.b)].ahead;
    // What is not known is NaN, which both comparisons are asked so as to pass over.
    return std::min(reaches.near_of_pair[setup.link_pair_of[index(id)]],
                    std::max(reaches.stop + ahead, least));
  }

  /// [m] Farther apart, bodies do not matter: those of their elements that are `nearest` do.
  double limitOf(PairId id, double nearest) const noexcept {
    return std::max(nearOf(id), std::min(reach, nearest));
  }
};

inline NearBodies nearBodies(const CycleSetup& setup, const CycleBuffers& buffers) noexcept {
  return {setup, buffers.reaches, buffers.memory.gaps, nearReachOf(setup), reachOf(setup.limits)};
}

/// Remembers a lower bound of the distance.
inline void rememberGap(double distance, const BodyPair& pair, PairId id,
                        KnownGaps& gaps) noexcept {
  gaps.of_pair[index(id)] =
      distance + (gaps.ways[index(pair.a)].all + gaps.ways[index(pair.b)].all);
}

}  // namespace collision_monitor
