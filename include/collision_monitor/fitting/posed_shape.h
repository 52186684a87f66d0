// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "collision_monitor/geometry/pose.h"
#include "collision_monitor/geometry/shapes.h"

namespace collision_monitor {

/// Points that a fit encloses. Usually the vertices of a convex hull: they are far fewer, and a
/// convex shape that holds them holds all points.
using Points = std::vector<Eigen::Vector3d>;

/// A shape placed in the frame of the points it was fitted to.
struct PosedShape {
  Shape shape;              ///< in its own body frame
  Pose geometry_from_body;  ///< where the shape sits in the frame of the points
};

/// The shape with its radius, or the half extents of a box, increased by `growth` [m]. It extends
/// at least that much farther in every direction.
Shape grown(const Shape& shape, double growth);

/// The largest signed distance of a point to the posed shape: the growth that encloses all points.
/// Negative when all are strictly inside. Error: rounding; provenExcess gives a bound.
double excessOver(const PosedShape& fit, const Points& points) noexcept;

}  // namespace collision_monitor
