// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "collision_monitor/fitting/posed_shape.h"

namespace collision_monitor {

/// Corners of a triangle.
using Corners = std::array<Eigen::Vector3d, 3>;

/// What bounds the error of a distance from a shape to any point between the given ones: the
/// rounding that provenExcess allows for, twice, as the points were moved before, and that of
/// cutting a hundred times.
double slackOf(const PosedShape& shape, const Points& points);

/// A union of shapes, each grown by one length, that is held against points and triangles between
/// given points. Says "inside" only where that is proven.
class ShapeUnion {
 public:
  ShapeUnion(const std::vector<PosedShape>& shapes, double growth, const Points& points);

  std::size_t size() const { return shapes_.size(); }

  /// Upper bound of the distance to the union; <= 0 proves the point inside. Units: metres.
  double excessOf(const Eigen::Vector3d& point) const;

  /// Bit i is set when the shape holds corner i.
  unsigned heldBy(std::size_t shape, const Corners& corners) const;

  /// How far from `inside` to `outside` the shape reaches, as a fraction; what is nearer is inside,
  /// for the shape is convex.
  double reachAlong(std::size_t shape, const Eigen::Vector3d& inside,
                    const Eigen::Vector3d& outside) const;

 private:
  double excessOver(std::size_t shape, const Eigen::Vector3d& point) const;

  std::vector<PosedShape> shapes_;
  std::vector<double> slacks_;
};

}  // namespace collision_monitor
