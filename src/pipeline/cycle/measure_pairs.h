// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/pipeline/setup.h"
#include "pipeline/data/cycle_data.h"
#include "pipeline/refine/refine_pairs.h"

namespace collision_monitor {

/// @pre `pairs` is sorted by id and joins known bodies only; `distances` has room for every pair.
void measurePairs(const CycleSetup& setup, const BodyPoses& body_poses,
                  const std::vector<PairId>& pairs, PairDistances& distances) noexcept;

/// As measurePairs, after what `distances` hold already.
void addPairs(const CycleSetup& setup, const BodyPoses& body_poses,
              const std::vector<PairId>& pairs, PairDistances& distances) noexcept;

/// Makes sure that the closest of all known pairs is among `distances`, which hold the
/// nearest within `reach` and what `refined` made of them. Costs nothing when one is that near;
/// otherwise searches all pairs, except those that were refined and those across two parts. What it
/// adds is not refined.
void measureClosest(const CycleSetup& setup, const BodyPoses& body_poses, RefineWork& refined,
                    double reach, PairDistances& distances) noexcept;

}  // namespace collision_monitor
