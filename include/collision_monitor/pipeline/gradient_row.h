// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "collision_monitor/pipeline/cycle_data.h"
#include "collision_monitor/pipeline/setup.h"

namespace collision_monitor {

/// Derivative of a pair's distance by one velocity of a joint, [m/rad] or [m/m].
struct GradientEntry {
  std::uint32_t variable{0};  ///< as jointTwist counts velocities
  double value{0.0};
};

/// How a pair's signed distance changes with the joints: only those between the two links are in
/// it, for what moves both changes nothing. Sorted by variable. The rate of the distance is the
/// sum of values times velocities, plus what moves the robots' roots.
using GradientRow = std::vector<GradientEntry>;

/// An empty row with room for every variable.
GradientRow makeGradientRow(const RobotModel& model);

/// The row of a measured pair, apart or overlapping; mimic joints count for their source.
/// Error: that of the witness points times the derivative of the normal: 1e-9 of the levers where
/// the distance is smooth. Limits: as distanceRate.
/// Source: distanceRate for the twist that each joint gives, as in Schulman et al., "Motion
/// planning with sequential convex optimization and convex collision checking" (2014), section V.
/// @pre both links are known, and `row` has room
void gradientRow(const CycleSetup& setup, const LinkPoses& poses, const PairDistance& distance,
                 GradientRow& row) noexcept;

}  // namespace collision_monitor
