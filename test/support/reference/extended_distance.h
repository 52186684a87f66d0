// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/pose.h"
#include "collision_monitor/geometry/shapes.h"

namespace collision_monitor::test {

/// Signed distance of a point to a placed shape with 64 bits of mantissa, written independently of
/// the library: the point's coordinates solve R x = p - t, whether or not R is orthonormal.
long double extendedDistance(const Shape& shape, const Pose& world_from_body,
                             const Eigen::Vector3d& point);

}  // namespace collision_monitor::test
