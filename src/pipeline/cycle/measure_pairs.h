// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/pipeline/setup.h"
#include "pipeline/cycle/cycle_buffers.h"

namespace collision_monitor {

/// @pre `pairs` is sorted by id and has known bodies only; `distances` has room for every pair.
void measurePairs(const CycleSetup& setup, const BodyPoses& body_poses,
                  const std::vector<PairId>& pairs, PairDistances& distances) noexcept;

/// As measurePairs, but appends to `distances`.
void addPairs(const CycleSetup& setup, const BodyPoses& body_poses,
              const std::vector<PairId>& pairs, PairDistances& distances) noexcept;

/// Makes sure that the distances hold the closest of all known pairs. Costs nothing if a pair is
/// within `reach`. Otherwise searches all pairs except refined ones and those of two parts. The
/// pair that it adds is not refined. @pre they hold the nearest pairs within `reach`,
/// refined as RefineWork says.
void measureClosest(const CycleSetup& setup, const LinkPoses& poses, double reach,
                    CycleBuffers& buffers) noexcept;

}  // namespace collision_monitor
