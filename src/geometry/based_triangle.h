// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>

#include "collision_monitor/geometry/triangle.h"

namespace collision_monitor {

/// Clamps to [0, 1]. NaN, from 0 / 0, becomes 1.
inline double clampToUnit(double parameter) noexcept {
  return std::max(0.0, std::min(1.0, parameter));
}

/// A triangle on its longest edge. The projection of the apex divides that base at
/// `apex_parameter`. This form keeps the precision of needles: base and height are accurate even
/// where the other edges are nearly parallel to the base. One frame for all; metres.
struct BasedTriangle {
  Eigen::Vector3d start;  ///< the base is start + t * along, 0 <= t <= 1
  Eigen::Vector3d along;
  double squared_length;
  Eigen::Vector3d apex;
  double apex_parameter;

  /// From the base to the apex, perpendicular to the base up to rounding.
  Eigen::Vector3d height() const noexcept { return apex - start - apex_parameter * along; }
};

inline BasedTriangle baseOf(const Triangle& triangle) noexcept {
  BasedTriangle based;
  based.squared_length = -1.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d& start = triangle[i];
    const Eigen::Vector3d along = triangle[(i + 1) % 3] - start;
    const double squared_length = along.squaredNorm();
    if (squared_length > based.squared_length) {
      based = {start, along, squared_length, triangle[(i + 2) % 3], 0.0};
    }
  }
  if (based.squared_length > 0.0) {
    based.apex_parameter =
        clampToUnit(based.along.dot(based.apex - based.start) / based.squared_length);
  }
  return based;
}

/// A point of the triangle: the closest one to `point` if that lies inside the triangle. If it lies
/// on the boundary, the caller has to test the edges. Triangles without area are legal.
/// Error: some ulps of the triangle's size and of the distance, however thin the triangle is.
inline Eigen::Vector3d closestOn(const BasedTriangle& triangle,
                                 const Eigen::Vector3d& point) noexcept {
  // The triangle's section across the base, through the projection of the point, is a short
  // segment. One more projection finds its closest point. Nothing is divided by an area.
  if (!(triangle.squared_length > 0.0)) {
    return triangle.start;
  }
  const double parameter =
      clampToUnit(triangle.along.dot(point - triangle.start) / triangle.squared_length);
  const Eigen::Vector3d on_base = triangle.start + parameter * triangle.along;
  const bool before_apex = parameter < triangle.apex_parameter;
  const Eigen::Vector3d end =
      before_apex ? triangle.start : Eigen::Vector3d(triangle.start + triangle.along);
  const double from_end = before_apex ? parameter / triangle.apex_parameter
                                      : (1.0 - parameter) / (1.0 - triangle.apex_parameter);
  // An apex over an end of the base gives 0 / 0. The section is then the edge at that end.
  const Eigen::Vector3d on_side =
      from_end <= 1.0 ? Eigen::Vector3d(end + from_end * (triangle.apex - end)) : triangle.apex;
  const Eigen::Vector3d across = on_side - on_base;
  const double squared_width = across.squaredNorm();
  return squared_width > 0.0
             ? Eigen::Vector3d(on_base +
                               clampToUnit(across.dot(point - on_base) / squared_width) * across)
             : on_base;
}

}  // namespace collision_monitor
