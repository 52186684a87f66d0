// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/cycle/cycle_buffers.h"

namespace collision_monitor {

/// Keeps the pairs that are near, and the nearest bodies of any two elements within the activation
/// distance. The result does not depend on which pairs were culled. Stores all measured distances
/// in the distance cache.
void keepNear(const CycleSetup& setup, const LinkPoses& poses, CycleBuffers& buffers) noexcept;

/// Measures deferred pairs whose elements were not refined in this cycle, and lone ones unless
/// others of their links are nearer, so that `distances` are as if nothing had been deferred.
/// Drops lone bodies that matter only as the nearest of their links, and are not. Afterwards
/// `deferred` holds the pairs measured here.
void measureDeferred(const CycleSetup& setup, const LinkPoses& poses,
                     CycleBuffers& buffers) noexcept;

}  // namespace collision_monitor
