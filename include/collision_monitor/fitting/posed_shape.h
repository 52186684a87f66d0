// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "collision_monitor/geometry/pose.h"
#include "collision_monitor/geometry/shapes.h"

namespace collision_monitor {

/// Points that a fit encloses: as a rule the vertices of a convex hull, which enclose as much as
/// all points do and are far fewer.
using Points = std::vector<Eigen::Vector3d>;

/// A shape and the place it was fitted to.
struct PosedShape {
  Shape shape;
  Pose geometry_from_body;  ///< where the shape sits in the frame of the points
};

/// The shape with its radius, or the half extents of a box, larger by `growth` [m]: it reaches at
/// least that much farther in every direction.
Shape grown(const Shape& shape, double growth);

/// The largest signed distance of a point to the posed shape: the growth that would enclose all,
/// negative when they are inside with room to spare. Error: rounding; see provenExcess for a bound.
double excessOver(const PosedShape& fit, const Points& points) noexcept;

}  // namespace collision_monitor
