// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "collision_monitor/pipeline/setup.h"

namespace collision_monitor {

/// [m] Smaller differences count as agreement: FCL's own tolerance.
constexpr double kTolerance = 1e-6;

struct ComparisonOptions {
  std::size_t poses{1000};
  unsigned seed{1};
  std::size_t most_depths{20000};  ///< limit for overlaps whose depth the slow reference computes
};

/// Results for one kind of shape pair, e.g. "capsule, box".
struct KindTally {
  std::size_t separated{0};
  std::size_t overlapping{0};
  std::size_t without_fcl{0};      ///< FCL threw or gave no answer
  double worst_against_fcl{0.0};   ///< [m] separated pairs on which FCL and we agree
  std::size_t decided_for_us{0};   ///< beyond the tolerance from FCL; the reference agrees with us
  std::size_t decided_for_fcl{0};  ///< ... the reference agrees with FCL, or with neither
  double worst_of_fcl{0.0};        ///< [m] FCL against the reference, among those decided
  std::size_t depths{0};           ///< overlaps compared with the reference
  double worst_depth{0.0};         ///< [m] our depth against the reference
};

/// A pair on which FCL and we differ, with the reference's result.
struct Disagreement {
  std::string pair;
  double ours{0.0};
  double fcl{0.0};  ///< NaN if FCL only said "overlap" or "apart"
  double reference{0.0};
};

struct Comparison {
  std::map<std::string, KindTally> kinds;
  std::vector<Disagreement> disagreements;  ///< the first hundred
  std::size_t poses{0};
  std::size_t verdicts{0};
  std::size_t wrong_verdicts{
      0};  ///< verdicts of the cycle that contradict the distances of FCL and the reference
};

/// Measures every checked pair by us and by FCL on the same enclosing shapes, in random poses:
/// joint values within their limits, every robot's root at the origin. Where the two differ, the
/// slow exact reference decides.
Comparison compareWithFcl(const CycleSetup& setup, const ComparisonOptions& options);

}  // namespace collision_monitor
