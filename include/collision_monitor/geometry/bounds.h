// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "collision_monitor/geometry/pose.h"
#include "collision_monitor/geometry/shapes.h"

namespace collision_monitor {

/// Axis-aligned box in the world frame, [m].
struct Aabb {
  Eigen::Vector3d min{Eigen::Vector3d::Zero()};  ///< corner of the lowest coordinates
  Eigen::Vector3d max{Eigen::Vector3d::Zero()};  ///< corner of the highest coordinates
};

/// True when the boxes overlap or touch. The test is closed, so a broad phase may report too many
/// pairs, never too few.
inline bool meets(const Aabb& a, const Aabb& b) noexcept {
  return (a.min.array() <= b.max.array()).all() && (b.min.array() <= a.max.array()).all();
}

/// The smallest axis-aligned box of the posed shape, from its support function along the six axis
/// directions. It is grown by `margin` and by a rounding allowance on every side, so it encloses
/// the shape in floating point too.
Aabb aabbOf(const Shape& shape, const Pose& world_from_body, double margin) noexcept;

/// The radius of a ball about the body's origin that holds the whole shape.
double boundingRadius(const Shape& shape) noexcept;

}  // namespace collision_monitor
