// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/cycle/cycle_buffers.h"

namespace collision_monitor {

/// Takes out candidates that are too far apart to matter: by the distances that were measured
/// before, less the ways since, by bounding spheres, which do not turn, and in a combined run what
/// is left by the separating axes of the boxes about their cores. Counts all three. Of two elements
/// that were refined in the last cycle it also takes out the bodies that cannot be the nearest, and
/// lets them wait.
void cullCandidates(const CycleSetup& setup, CycleBuffers& buffers) noexcept;

}  // namespace collision_monitor
