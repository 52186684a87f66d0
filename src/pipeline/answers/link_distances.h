// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "collision_monitor/pipeline/setup.h"
#include "pipeline/data/cycle_data.h"
#include "pipeline/refine/refine_pairs.h"

/// Distances of pairs of links in one state, outside of a cycle: whatever it takes, not within a
/// budget.
namespace collision_monitor {

/// Inputs, results and scratch of measureWithin, sized at set-up.
struct LinkDistances {
  BodyPoses body_poses;
  std::vector<PairId> candidates;  ///< the pairs to measure, sorted
  PairDistances distances;
  /// By LinkPairIndex: index into distances.pairs of the nearest shapes, or kNone if none were
  /// measured. As in a cycle, an estimate counts before a deeper lower bound, and makes a deeper
  /// exact distance an estimate.
  std::vector<std::uint32_t> nearest;
  std::vector<std::uint32_t> estimated;  ///< by LinkPairIndex: as PairEvents::estimated
  RefineWork refine;
  PairMemory memory;  ///< only what refinePairs uses is sized

  /// @pre something was measured
  const PairDistance& of(LinkPairIndex pair) const noexcept {
    return distances.pairs[nearest[pair]];
  }
};

LinkDistances makeLinkDistances(const CycleSetup& setup);

/// Places bodies and elements.
void placeAll(const CycleSetup& setup, const LinkPoses& poses, LinkDistances& links) noexcept;

/// Which distances are asked for.
enum class Asked : unsigned char {
  within,   ///< those up to the distance
  nearest,  ///< the least up to the distance
};

/// Measures the candidates, and refines those within a distance [m]. Pairs whose distances are not
/// asked for may keep a lower bound. Does not allocate.
/// @pre the links are placed; candidates have known relative poses.
void measureWithin(const CycleSetup& setup, double distance, Asked asked,
                   LinkDistances& links) noexcept;

/// Whether a pair is nearer than another, or as near and measured: a bound stops at the distance
/// that ended its search.
inline bool isNearer(const PairDistance& one, const PairDistance& other) noexcept {
  return one.measured.distance < other.measured.distance ||
         (one.measured.distance == other.measured.distance && !one.is_raised && other.is_raised);
}

/// The nearest pair among those that `is_asked` accepts; kNone if none was measured.
template <class IsAsked>
LinkPairIndex closestOf(const LinkDistances& links, const IsAsked& is_asked) {
  LinkPairIndex closest = kNone;
  for (LinkPairIndex i = 0; i < links.nearest.size(); ++i) {
    if (links.nearest[i] != kNone && is_asked(i) &&
        (closest == kNone || isNearer(links.of(i), links.of(closest)))) {
      closest = i;
    }
  }
  return closest;
}

}  // namespace collision_monitor
