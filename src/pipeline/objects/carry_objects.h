// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "model/object_links.h"
#include "pipeline/data/cycle_data.h"

/// What objects have from the frame or link that carries them. Both functions cost next to nothing
/// while a carrier rests.
namespace collision_monitor {

/// Gives objects the pose that their carrier leads to, and its status, part and age.
/// @param objects objectRuns of the model
void carryPoses(const RobotModel& model, const std::vector<ObjectRun>& objects,
                LinkPoses& poses) noexcept;

/// Gives objects the velocity of their carrier.
void carryVelocities(const std::vector<ObjectRun>& objects, LinkPoses& poses) noexcept;

}  // namespace collision_monitor
