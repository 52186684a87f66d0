// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/pipeline/setup.h"
#include "support/random_poses.h"

/// Set-ups whose pairs have limits of their own.
namespace collision_monitor::test {

/// Sets every limit of every pair.
PairRule ruleForAll(const Limits& limits, const CycleSetup& setup);

/// Sets every limit of about a third of the pairs.
PairRule ruleForSome(const Limits& limits, const CycleSetup& setup, Random& random);

/// Limits of centimetres and tenths of a second. The contact distance is >= 0.
Limits randomLimits(Random& random);

/// Replaces the rules of a hand-made set-up.
void giveRules(const std::vector<PairRule>& rules, CycleSetup& setup);

}  // namespace collision_monitor::test
