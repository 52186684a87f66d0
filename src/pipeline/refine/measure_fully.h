// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/refine/refine_pairs.h"

namespace collision_monitor {

/// Measures elements that refinePairs skipped or left with a shortfall, if some of the budget is
/// left. If none is, those with a shortfall come first in the next cycle.
/// @param place index of their entry in `distances`; of skipped elements that of their nearest
/// bodies
/// @return whether they are measured.
bool measureFully(const CycleSetup& setup, const BodyPoses& body_poses, PairMemory& memory,
                  std::uint32_t place, RefineWork& work, PairDistances& distances) noexcept;

/// Raises the distance of skipped elements to the bound that their last measurement leaves. Their
/// time to contact is then to be found anew.
void raiseByRecall(const CycleSetup& setup, const BodyPoses& body_poses, PairMemory& memory,
                   std::uint32_t place, RefineWork& work, PairDistances& distances) noexcept;

/// Finds the entry of the nearest bodies of each task, and clears RefineWork::is_passed of its
/// elements.
void placeTasks(const CycleSetup& setup, RefineWork& work, const PairDistances& distances) noexcept;

/// Of tasks whose elements are passed, drops all entries but that of the nearest bodies.
/// @pre placeTasks was called, and no entry was dropped since then
void dropOtherBodies(const CycleSetup& setup, const RefineWork& work,
                     PairDistances& distances) noexcept;

}  // namespace collision_monitor
