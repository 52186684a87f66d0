// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/fitting/posed_shape.h"

namespace collision_monitor {

/// The greatest number of local minima that are compared for one goal.
constexpr std::size_t kMaxFits = 3;

/// Locally least shapes around the points. The first has the least volume of all: it is the result
/// of fitBox or fitCapsule. Others may overshoot less.
/// @pre at least one point; all finite.
std::vector<PosedShape> smallBoxes(const Points& points);
std::vector<PosedShape> smallCapsules(const Points& points);

/// Rounded boxes, least volume first. They start from boxes and capsules, and are not compared with
/// these.
std::vector<PosedShape> smallRoundedBoxes(const Points& points,
                                          const std::vector<PosedShape>& boxes,
                                          const std::vector<PosedShape>& capsules);

}  // namespace collision_monitor
