// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "collision_monitor/geometry/ids.h"
#include "pipeline/cycle/cycle_buffers.h"

/// What cycles spend of refine_budget, and on which links where it does not suffice. Steps are
/// those of RefineLimits::budget.
namespace collision_monitor {

struct PairWork {
  LinkPairIndex link_pair{kNone};  ///< kNone: no pair
  std::uint64_t work{0};
};

/// Of several cycles; plain data of fixed size.
struct BudgetUse {
  /// That the pairs are of; to compare with, for it may have ended.
  const CycleSetup* setup{nullptr};
  std::uint64_t cycles{0};
  std::uint64_t short_cycles{0};  ///< of these, they left pairs for want of budget
  std::uint64_t work{0};          ///< of all cycles
  std::uint64_t worst{0};         ///< steps of the cycle with most of them
  std::uint64_t short_work{0};    ///< of the short cycles
  double short_time{0.0};         ///< [s] that these took
  /// Pairs of links that took most in the short cycles, the most first.
  std::array<PairWork, 3> most{};
};

/// Adds up cycles, sized at set-up.
struct BudgetTally {
  BudgetUse use;
  std::vector<std::uint64_t> steps_of;  ///< by LinkPairIndex: in the short cycles
  std::vector<LinkPairIndex> counted;   ///< those with steps
};

BudgetTally makeBudgetTally(const CycleSetup& setup);

/// As if there had been no cycle.
void restart(BudgetTally& tally) noexcept;

/// Adds the cycle that has just ended, and took `time` [s]. Looks at its pairs only where the
/// budget did not suffice. Neither allocates nor throws.
/// @pre the buffers are those of the tally's set-up
void addCycle(const CycleBuffers& buffers, double time, BudgetTally& tally) noexcept;

}  // namespace collision_monitor
