// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/fitting/posed_shape.h"

namespace collision_monitor {

/// The capsule of least volume that holds all points, or one within 1 % of it.
///
/// Error: every point is inside up to rounding. The least volume is not proven. Descents start from
/// the best of many axis directions spread over the half sphere. Tests keep it within 1 % of a far
/// longer search.
/// Limits: coincident and collinear points give radius 0. If no capsule is better than a sphere,
/// half_length is 0.
/// @pre at least one point; all finite.
PosedShape fitCapsule(const Points& points);

}  // namespace collision_monitor
