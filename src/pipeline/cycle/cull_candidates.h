// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/cycle/cycle_buffers.h"

namespace collision_monitor {

/// Fills `candidates` with the listed pairs that may matter. Leaves out those that are too far
/// apart by the distance cache, then by bounding spheres, in a combined run also by separating axes
/// of the oriented boxes. Counts each kind. It defers bodies that may not be needed: of two
/// elements refined in the last cycle, and lone ones, those that were not the nearest. Fills
/// RefineWork::near_bodies.
void cullCandidates(const CycleSetup& setup, const LinkPoses& poses,
                    CycleBuffers& buffers) noexcept;

}  // namespace collision_monitor
