// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/refine/refine_pairs.h"

namespace collision_monitor {

/// Forgets the last cycle's tasks and lists this one's: one for each pair of elements that is near
/// enough, with its nearest bodies. Those that waited longest come first, then the nearest.
void listTasks(const CycleSetup& setup, const PairMemory& memory, const PairDistances& distances,
               RefineWork& work) noexcept;

}  // namespace collision_monitor
