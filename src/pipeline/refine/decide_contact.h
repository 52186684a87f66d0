// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/refine/refinement.h"

namespace collision_monitor {

/// Decides whether the geometries of touching enclosing shapes touch, which takes only part of the
/// work of a distance. First tries to prove that they are too far apart for a contact to be held by
/// hysteresis, unless they overlapped in the last cycle; then whether they touch. Leaves a part of
/// the budget for distances, so that every pair has its turn.
void decideContact(const Refinement& all, RefineTask& task) noexcept;

}  // namespace collision_monitor
