// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/fitting/posed_shape.h"

namespace collision_monitor {

/// The oriented box of least volume that holds all points, or one within 1 % of it.
///
/// Error: every point is inside up to rounding. The least volume is not proven: the search starts
/// from rotations spread evenly over all and descends from the best; tests hold it to within 1 % of
/// an exhaustive search.
/// Limits: coincident, collinear and coplanar points are legal and get zero half extents; of flat
/// boxes, whose volume is all 0, the one of least area is returned.
/// Source: Chang, Gorissen, Melchior, "Fast Oriented Bounding Box Optimization on the Rotation
/// Group SO(3, R)" (2011), sections 3.2 to 3.4: simplex search on the rotations, then rotating
/// calipers about each axis; departs from it in starting from a fixed spread instead of a genetic
/// search, so that the same points give the same box.
/// @pre at least one point; all finite.
PosedShape fitBox(const Points& points);

}  // namespace collision_monitor
