// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/fitting/posed_shape.h"

namespace collision_monitor {

/// Locally least shapes around the points, least volume first, at most `kMaxFits` of them. The
/// first is the result of fitBox, fitCapsule; the others may overshoot less.
/// @pre at least one point; all finite.
std::vector<PosedShape> smallBoxes(const Points& points);
std::vector<PosedShape> smallCapsules(const Points& points);

/// Rounded boxes proper, which start from boxes and capsules and are not compared with them.
std::vector<PosedShape> smallRoundedBoxes(const Points& points,
                                          const std::vector<PosedShape>& boxes,
                                          const std::vector<PosedShape>& capsules);

constexpr std::size_t kMaxFits = 3;

}  // namespace collision_monitor
