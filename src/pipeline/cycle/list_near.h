// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/cycle/cycle_buffers.h"

namespace collision_monitor {

/// [m] Pairs that are farther than matters by more than this are left out of the list.
constexpr double kListMargin = 0.025;

/// Fills DistanceCache::listed, unless the last list still serves: no pair that is near enough to
/// matter is missing. Bounds of all bodies are looked at only to make a list. It serves in the next
/// cycles, until two bodies may have used up the margin by travel or by faster motion ahead, or
/// until many objects start to move or come to rest. No list is made where motions are fast or
/// unknown, or where many objects have no trees.
///
/// Source: Verlet, "Computer 'experiments' on classical fluids I" (1967). Departure: the list also
/// leaves out pairs by cached distances and motion ahead.
/// @pre travel is accumulated. @param have_links_changed since the last cycle
void listNear(const CycleSetup& setup, const LinkPoses& poses, bool have_links_changed,
              CycleBuffers& buffers) noexcept;

}  // namespace collision_monitor
