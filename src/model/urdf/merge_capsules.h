// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/model/robot_model.h"

namespace collision_monitor {

/// [m] Limit for the distance between a sphere's center and the end of its cylinder, and for the
/// difference of radii, up to which the three are one capsule. Large enough for angles with four
/// decimals, such as 1.5708 (3.7e-6 rad), on half a cylinder of 0.5 m; far below manufacturing
/// tolerances.
constexpr double kCapsuleTolerance = 1e-6;

/// Replaces each cylinder that has a sphere of its radius on both ends by the equivalent capsule,
/// which keeps the cylinder's position in the list and its name. One sphere may close two
/// cylinders, as in an elbow.
///
/// Error: exact if the numbers agree exactly; otherwise the capsule encloses all three and extends
/// beyond them by at most 2 kCapsuleTolerance.
void mergeCapsules(std::vector<CollisionElement>& collisions);

}  // namespace collision_monitor
