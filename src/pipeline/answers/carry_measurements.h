// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pipeline/answers/carry_over.h"
#include "pipeline/cycle/cycle_buffers.h"

/// Measurements between links of robots go on in the next set-up, so that a change of objects
/// measures none of them anew.
namespace collision_monitor {

/// By former ElementPairIndex: the new one, for pairs of robots. Empty if the set-ups do not check
/// the same ones: then none can be taken over. @pre both have the same robots
std::vector<ElementPairIndex> planMeasurements(const CycleSetup& from, const CycleSetup& to,
                                               const CarryPlan& plan);

/// Takes what the former set-up keeps of pairs of robots; it keeps none of it. Ends
/// RefineWork::skips_robots.
/// @param new_of planMeasurements, not empty
void carryMeasurements(const std::vector<ElementPairIndex>& new_of, CycleBuffers& former,
                       CycleBuffers& buffers) noexcept;

}  // namespace collision_monitor
