// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_monitor/fitting/posed_shape.h"
#include "collision_monitor/narrow_phase/signed_distance.h"

/// The two-capsule exercise: three clicks make a capsule, two capsules show their distance.
///
/// Frame: all points in that of the board that is clicked on.
namespace collision_monitor::two_capsules {

struct Exercise {
  Points clicks;        ///< those taken: one end, a point on the rim, the other end; twice
  std::string refusal;  ///< why the last click was not taken; empty if it was
};

/// Takes a click, or says in `refusal` why it changes nothing: not finite or beyond 1000 m, a rim
/// within 1 mm of its end, or both capsules stand. A new exercise begins with a new Exercise.
void takeClick(const Eigen::Vector3d& point, Exercise& exercise);

/// The capsules that have a radius, in the order of the clicks: with the rim a capsule of length 0
/// about its first end, with the other end the whole of it. Equal ends leave it a sphere.
std::vector<PosedShape> capsulesOf(const Exercise& exercise);

/// From the first capsule to the second, once both stand.
std::optional<SignedDistance> distanceOf(const Exercise& exercise);

/// "0.123 m", "overlap 0.020 m", or "touching" for what is 0 in print.
std::string distanceText(double distance);

/// One sentence: what to click next; above it, why the last click was refused.
std::string promptOf(const Exercise& exercise);

}  // namespace collision_monitor::two_capsules
