// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/refine/refinement.h"

namespace collision_monitor {

/// Tells contacts of enclosing shapes that are none of the geometries, and no more: whether
/// geometries touch takes a part of the steps of their distance. First whether they are so far
/// apart that no contact is held, unless they overlapped in the last cycle; then whether they
/// touch. Leaves a part of the budget for distances, so that every pair has its turn.
void decideContact(const Refinement& all, RefineTask& task) noexcept;

}  // namespace collision_monitor
