// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/fitting/posed_shape.h"

namespace collision_monitor {

/// At most this many local minima of one goal are looked at.
constexpr std::size_t kMaxFits = 3;

/// Locally least shapes around the points. The first has the least volume of all and is the result
/// of fitBox or fitCapsule; the others may overshoot less.
/// @pre at least one point; all finite.
std::vector<PosedShape> smallBoxes(const Points& points);
std::vector<PosedShape> smallCapsules(const Points& points);

/// Rounded boxes proper, least volume first, which start from boxes and capsules and are not
/// compared with them.
std::vector<PosedShape> smallRoundedBoxes(const Points& points,
                                          const std::vector<PosedShape>& boxes,
                                          const std::vector<PosedShape>& capsules);

}  // namespace collision_monitor
