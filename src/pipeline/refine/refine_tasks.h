// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/refine/refine_pairs.h"

namespace collision_monitor {

/// Replaces the last cycle's tasks by those of this cycle: one for each near pair of elements, with
/// its nearest bodies. Pairs starved longest come first, then nearest ones.
void listTasks(const CycleSetup& setup, const PairMemory& memory, const PairDistances& distances,
               RefineWork& work) noexcept;

}  // namespace collision_monitor
