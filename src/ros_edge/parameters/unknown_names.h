// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/model/world.h"
#include "pipeline/setup/setup_input.h"

/// Names that match nothing.
namespace collision_monitor {

/// Every frame and link that the objects name: those of robots that could not be read are no
/// faults.
KnownPlaces anyPlaces(const std::vector<WorldObject>& objects);

/// Adds names in rules that are neither links nor objects as errors. Objects with faults count,
/// too, so that no fault only follows from another.
void checkRuleNames(const DocumentText& rules, const SetupInput& robots,
                    const std::vector<WorldObject>& objects, SetupReport& report);

/// The warnings about names in rules that match nothing.
std::vector<Problem> warningsOfNames(const CycleSetup& setup);

}  // namespace collision_monitor
