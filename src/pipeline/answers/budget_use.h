// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "collision_monitor/geometry/ids.h"
#include "pipeline/cycle/cycle_buffers.h"

/// How much of refine_budget cycles use, and for which links where it does not suffice. Work is
/// that of RefineLimits::budget.
namespace collision_monitor {

struct PairWork {
  LinkPairIndex link_pair{kNone};  ///< kNone: no pair
  std::uint64_t work{0};
};

/// Sums of several cycles. Plain data of fixed size.
struct BudgetUse {
  /// The set-up of the pairs. For comparison only: it may no longer exist.
  const CycleSetup* setup{nullptr};
  std::uint64_t cycles{0};
  std::uint64_t short_cycles{0};  ///< cycles of these whose budget starved pairs
  std::uint64_t work{0};          ///< of all cycles
  std::uint64_t worst{0};         ///< the largest work of one cycle
  std::uint64_t short_work{0};    ///< of the short cycles
  double short_time{0.0};         ///< [s] duration of the short cycles
  /// The link pairs of most work in the short cycles, in descending order.
  std::array<PairWork, 3> most{};
};

/// Adds up cycles. Sized at set-up.
struct BudgetTally {
  BudgetUse use;
  std::vector<std::uint64_t> work_of;  ///< by LinkPairIndex: work in the short cycles
  std::vector<LinkPairIndex> counted;  ///< pairs with work
};

BudgetTally makeBudgetTally(const CycleSetup& setup);

/// Resets the tally to zero cycles.
void restart(BudgetTally& tally) noexcept;

/// Adds the cycle that has just ended and took `time` [s]. Visits its pairs only if the budget
/// starved some. Neither allocates nor throws.
/// @pre the buffers belong to the tally's set-up
void addCycle(const CycleBuffers& buffers, double time, BudgetTally& tally) noexcept;

}  // namespace collision_monitor
