// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/refine/refine_pairs.h"

namespace collision_monitor {

/// Measures elements that refinePairs skipped or left with a shortfall, if some of the budget is
/// left. If none is, those with a shortfall come first in the next cycle.
/// @param place index of their entry in `distances`; of skipped elements that of placeOfNearest
/// @return whether they are measured.
bool measureFully(const CycleSetup& setup, const BodyPoses& body_poses, PairMemory& memory,
                  std::uint32_t place, RefineWork& work, PairDistances& distances) noexcept;

/// Raises the distance of skipped elements to the bound that their last measurement leaves. Their
/// time to contact is then to be found anew.
void raiseByRecall(const CycleSetup& setup, const BodyPoses& body_poses, PairMemory& memory,
                   std::uint32_t place, RefineWork& work, PairDistances& distances) noexcept;

/// Of the entries of the same elements as that at `place`, the place of the nearest bodies.
std::uint32_t placeOfNearest(const CycleSetup& setup, const PairDistances& distances,
                             std::uint32_t place) noexcept;

/// Marks all other entries of these elements. dropMarked then removes them.
void markOtherBodies(const CycleSetup& setup, std::uint32_t place,
                     PairDistances& distances) noexcept;

void dropMarked(PairDistances& distances) noexcept;

}  // namespace collision_monitor
