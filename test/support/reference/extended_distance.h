// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/pose.h"
#include "collision_monitor/geometry/shapes.h"

namespace collision_monitor::test {

/// Signed distance of a point to a placed shape with 64-bit mantissa, independent of the library:
/// the point's coordinates solve R x = p - t even if R is not orthonormal.
long double extendedDistance(const Shape& shape, const Pose& world_from_body,
                             const Eigen::Vector3d& point);

}  // namespace collision_monitor::test
