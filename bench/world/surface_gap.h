// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/geometry.h"
#include "collision_monitor/geometry/pose.h"

namespace collision_monitor::test {

/// [m] The signed distance by the slow reference; of a mesh that of its nearest or deepest
/// triangle, so 0 or less where its surface meets the other geometry.
double surfaceGap(const Geometry& a, const Pose& world_from_a, const Geometry& b,
                  const Pose& world_from_b);

}  // namespace collision_monitor::test
