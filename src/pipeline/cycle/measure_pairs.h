// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/pipeline/setup.h"
#include "pipeline/data/cycle_data.h"
#include "pipeline/refine/refine_pairs.h"

namespace collision_monitor {

/// @pre `pairs` is sorted by id and has known bodies only; `distances` has room for every pair.
void measurePairs(const CycleSetup& setup, const BodyPoses& body_poses,
                  const std::vector<PairId>& pairs, PairDistances& distances) noexcept;

/// As measurePairs, but appends to `distances`.
void addPairs(const CycleSetup& setup, const BodyPoses& body_poses,
              const std::vector<PairId>& pairs, PairDistances& distances) noexcept;

/// Makes sure that `distances` hold the closest of all known pairs. Costs nothing if a pair is
/// within `reach`. Otherwise searches all pairs except refined ones and those of two parts. The
/// pair that it adds is not refined. @pre `distances` hold the nearest pairs within `reach`,
/// refined as `refined` says.
void measureClosest(const CycleSetup& setup, const BodyPoses& body_poses, RefineWork& refined,
                    double reach, PairDistances& distances) noexcept;

}  // namespace collision_monitor
