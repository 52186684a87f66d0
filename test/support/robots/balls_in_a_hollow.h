// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "collision_monitor/pipeline/setup.h"
#include "pipeline/data/cycle_data.h"

/// Balls in the hollow of an angle, whose one shape they all overlap. With a budget of 150 a cycle
/// refines only some of these pairs.
namespace collision_monitor::test {

CycleSetup ballsInAHollow(std::uint32_t budget);

/// All links known; none touches another.
LinkPoses posesInAHollow(const CycleSetup& setup);

}  // namespace collision_monitor::test
