// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "comparison.h"
#include "pipeline/data/cycle_data.h"

namespace collision_monitor {

/// Calls `use` with each of `options.poses` random poses of the robots, with their roots at the
/// origin.
///
/// Joint values are uniform within the limits, or within half a turn or 1 m without limits.
/// Rotations of floating joints are uniform over all rotations.
void forRandomPoses(const CycleSetup& setup, const ComparisonOptions& options,
                    const std::function<void(const LinkPoses&)>& use);

}  // namespace collision_monitor
