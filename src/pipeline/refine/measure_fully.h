// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/refine/refine_pairs.h"

namespace collision_monitor {

/// Measures elements that refinePairs skipped or left with a shortfall, if some of the budget is
/// left. If none is, they come first in the next cycle.
/// @param place index of their entry in `distances`. dropOtherBodies then removes other entries of
///     elements that were skipped.
void measureFully(const CycleSetup& setup, const BodyPoses& body_poses, PairMemory& memory,
                  std::uint32_t place, RefineWork& work, PairDistances& distances) noexcept;

/// Raises the distance of skipped elements to the bound that their last measurement leaves.
void raiseByRecall(const CycleSetup& setup, const BodyPoses& body_poses, PairMemory& memory,
                   std::uint32_t place, RefineWork& work, PairDistances& distances) noexcept;

/// Call it after all calls of measureFully.
void dropOtherBodies(PairDistances& distances) noexcept;

}  // namespace collision_monitor
