// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/fitting/posed_shape.h"

namespace collision_monitor {

/// A rounded box of small volume that holds all points: never larger than the result of fitSphere,
/// fitCapsule or fitBox on the same points, for these are rounded boxes too.
///
/// Error: every point is inside up to rounding. A local minimum of the volume, the best of several
/// descents; how far it is from the least is not known.
/// Limits: those of the three others.
/// @pre at least one point; all finite.
PosedShape fitRoundedBox(const Points& points);

}  // namespace collision_monitor
