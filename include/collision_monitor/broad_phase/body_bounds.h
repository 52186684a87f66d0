// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/geometry/bounds.h"
#include "collision_monitor/geometry/ids.h"

namespace collision_monitor {

/// One box per body, in the world frame. Each is grown by half the activation distance of the
/// cycle, so the boxes of two bodies within that distance of each other meet.
struct BodyBounds {
  std::vector<Aabb> boxes;           ///< by BodyId, [m]
  std::vector<unsigned char> known;  ///< 0: the pose is unknown and the box means nothing
  /// [m] Further growth of a box for motion to come. NaN: not known.
  std::vector<double> ahead{};
};

}  // namespace collision_monitor
