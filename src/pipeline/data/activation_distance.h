// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/pipeline/setup.h"

/// The activation distance: how near a pair must be to matter to a cycle.
namespace collision_monitor {

/// The distance at or below which pairs are published, raise verdicts or keep them by hysteresis.
/// Units: metres.
double activationDistanceOf(const Limits& limits) noexcept;

/// The distance at or below which pairs are refined, raise verdicts or keep them by hysteresis.
double nearActivationDistanceOf(const CycleSetup& setup, const Limits& limits) noexcept;

/// How near any pair must be to matter to a cycle at rest, for boxes: at least the activation
/// distances of all pairs, and the distance at which scaleSpeed acts.
double farthestActivationDistanceOf(const CycleSetup& setup) noexcept;

/// The least activation distance of all pairs: no pair nearer than this is left out.
double leastActivationDistanceOf(const CycleSetup& setup) noexcept;

}  // namespace collision_monitor
