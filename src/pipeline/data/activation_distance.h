// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/pipeline/setup.h"

/// How near a pair must be to matter to a cycle.
namespace collision_monitor {

/// Pairs at this distance or nearer matter to a cycle: to be published, warned of or kept by
/// hysteresis. Units: metres.
double activationDistanceOf(const Limits& limits) noexcept;

/// The same without what is only published: to be refined, warned of or kept by hysteresis.
double nearActivationDistanceOf(const CycleSetup& setup) noexcept;

}  // namespace collision_monitor
