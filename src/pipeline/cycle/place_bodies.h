// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/pipeline/setup.h"
#include "pipeline/data/cycle_data.h"

namespace collision_monitor {

/// Makes poses sized for the set-up, all unknown.
BodyPoses makeBodyPoses(const CycleSetup& setup);

void placeBodies(const CycleSetup& setup, const LinkPoses& poses, BodyPoses& body_poses) noexcept;

/// Places elements, for the stages that refine.
/// @pre the bodies are placed.
void placeElements(const CycleSetup& setup, const LinkPoses& poses, BodyPoses& body_poses) noexcept;

}  // namespace collision_monitor
