// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/geometry/bounds.h"
#include "collision_monitor/geometry/ids.h"

namespace collision_monitor {

/// One box a body, world frame, already grown by half the reach of the cycle,
/// so that bodies within reach of each other have boxes that meet.
struct BodyBounds {
  std::vector<Aabb> boxes;
  std::vector<unsigned char> known;  ///< 0: the pose is unknown and the box means nothing
  std::vector<double>
      ahead{};  ///< [m] by which a box was grown beyond that, for motion to come; NaN: not known
};

}  // namespace collision_monitor
