// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/model/robot_model.h"

namespace collision_monitor {

/// How far the center of a sphere may lie from the end of its cylinder, and how
/// much the radii may differ, for the three to be one capsule. Units: metres.
/// Wide enough for angles written with four decimals, as 1.5708 (3.7e-6 rad) on
/// half a cylinder of 0.5 m; far below what a robot is built to.
constexpr double kCapsuleTolerance = 1e-6;

/// Replaces each cylinder that has a sphere of its own radius on both ends by
/// the capsule that the three make up, in the place of the cylinder and with its
/// name. One sphere may close two cylinders, as in an elbow.
///
/// Error: exact where the numbers agree exactly; otherwise the capsule encloses
/// all three and reaches beyond them by at most 2 kCapsuleTolerance.
void mergeCapsules(std::vector<CollisionElement>& collisions);

}  // namespace collision_monitor
