// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/pipeline/setup.h"
#include "pipeline/data/cycle_data.h"

namespace collision_monitor {

void judgePairs(const CycleSetup& setup, const BodyPoses& body_poses,
                const LinkVelocities& velocities, const PairDistances& distances,
                PairMemory& memory, PairEvents& events) noexcept;

}  // namespace collision_monitor
