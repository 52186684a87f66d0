// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/fitting/posed_shape.h"

namespace collision_monitor {

/// The oriented box of least volume that holds all points, or one within 1 % of it.
///
/// Error: every point is inside up to rounding. The least volume is not proven. The search starts
/// from evenly spread rotations and descends from the best. Tests keep it within 1 % of an
/// exhaustive search.
/// Limits: coincident, collinear and coplanar points are legal and get zero half extents. Flat
/// boxes all have volume 0; of these the one of least area is returned.
/// Source: Chang, Gorissen, Melchior, "Fast Oriented Bounding Box Optimization on the Rotation
/// Group SO(3, R)" (2011), sections 3.2 to 3.4: simplex search on the rotations, then rotating
/// calipers about each axis. Departs from it: starts from a fixed spread, not a genetic search, so
/// the same points give the same box.
/// @pre at least one point; all finite.
PosedShape fitBox(const Points& points);

}  // namespace collision_monitor
