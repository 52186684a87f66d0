// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "collision_monitor/geometry/pose.h"
#include "collision_monitor/geometry/shapes.h"

namespace collision_monitor {

/// Axis-aligned box in the world frame, [m].
struct Aabb {
  Eigen::Vector3d min{Eigen::Vector3d::Zero()};
  Eigen::Vector3d max{Eigen::Vector3d::Zero()};
};

/// Touching boxes meet: the test is closed, so a broad phase may report too
/// much, never too little.
inline bool meets(const Aabb& a, const Aabb& b) noexcept {
  return (a.min.array() <= b.max.array()).all() && (b.min.array() <= a.max.array()).all();
}

/// The least axis-aligned box of the posed shape, from its support function in
/// the six axis directions, grown by `margin` on every side and by a rounding
/// allowance so that it encloses the shape in floating point too.
Aabb aabbOf(const Shape& shape, const Pose& world_from_body, double margin) noexcept;

/// Radius about the body origin that holds the whole shape, whatever its rotation.
double boundingRadius(const Shape& shape) noexcept;

}  // namespace collision_monitor
