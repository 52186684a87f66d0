// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "collision_monitor/fitting/posed_shape.h"

namespace collision_monitor {

/// Corners of a triangle.
using Corners = std::array<Eigen::Vector3d, 3>;

/// Bounds the error of a distance from a shape to any point between the given ones. It covers twice
/// the rounding of provenExcess, because the points were transformed before, and the rounding of a
/// hundred cuts.
double slackOf(const PosedShape& shape, const Points& points);

/// A union of shapes, all grown by one length, for tests of points and of triangles between given
/// points. Reports "inside" only where that is proven.
class ShapeUnion {
 public:
  ShapeUnion(const std::vector<PosedShape>& shapes, double growth, const Points& points);

  std::size_t size() const { return shapes_.size(); }

  /// An upper bound of the distance to the union; <= 0 proves the point inside. Units: metres.
  double excessOf(const Eigen::Vector3d& point) const;

  /// Bit i is set if the shape holds corner i.
  unsigned heldBy(std::size_t shape, const Corners& corners) const;

  /// The fraction of the segment from `inside` to `outside` that the shape holds. The shape is
  /// convex, so nearer points are inside too.
  double reachAlong(std::size_t shape, const Eigen::Vector3d& inside,
                    const Eigen::Vector3d& outside) const;

 private:
  double excessOver(std::size_t shape, const Eigen::Vector3d& point) const;

  std::vector<PosedShape> shapes_;
  std::vector<double> slacks_;
};

}  // namespace collision_monitor
