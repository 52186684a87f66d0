// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/fitting/posed_shape.h"

namespace collision_monitor {

/// A rounded box of small volume that holds all points. It is never larger than fitSphere,
/// fitCapsule or fitBox give for the same points, because these are rounded boxes too.
///
/// Error: every point is inside up to rounding. The volume is a local minimum, the best of several
/// descents; its distance from the least volume is unknown.
/// Limits: as those three.
/// @pre at least one point; all finite.
PosedShape fitRoundedBox(const Points& points);

}  // namespace collision_monitor
