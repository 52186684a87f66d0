// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/cycle/cycle_buffers.h"

namespace collision_monitor {

/// Keeps of what was measured the pairs that are near, and of each two elements within reach the
/// nearest bodies: what is left does not depend on what was culled, nor by what. Remembers all
/// distances as gaps.
void keepNear(const CycleSetup& setup, CycleBuffers& buffers) noexcept;

/// Measures what waits as well, where the elements were not refined in this cycle: `distances` are
/// then as if nothing had waited. What still waits then is what was measured.
void measureDeferred(const CycleSetup& setup, CycleBuffers& buffers) noexcept;

}  // namespace collision_monitor
