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
/// Frames: all points are in the frame of the clicked board.
namespace collision_monitor::two_capsules {

struct Exercise {
  Points clicks;  ///< accepted clicks: one end, a point on the rim, the other end; for two capsules
  std::string refusal;  ///< why the last click was not taken; empty if it was
};

/// Takes a click. If it changes nothing, `refusal` says why: not finite or beyond 1000 m, a rim
/// within 1 mm of its end, or both capsules exist already. Create a new Exercise to start again.
void takeClick(const Eigen::Vector3d& point, Exercise& exercise);

/// The capsules that have a radius, in the order of the clicks. After the rim click, a capsule has
/// length 0 at its first end; the second end completes it. Equal ends leave it a sphere.
std::vector<PosedShape> capsulesOf(const Exercise& exercise);

/// From the first capsule to the second, once both exist.
std::optional<SignedDistance> distanceOf(const Exercise& exercise);

/// "0.123 m", "overlap 0.020 m", or "touching" if it prints as 0.
std::string distanceText(double distance);

/// One sentence: what to click next, preceded by why the last click was refused.
std::string promptOf(const Exercise& exercise);

}  // namespace collision_monitor::two_capsules
