// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "collision_monitor/fitting/posed_shape.h"

namespace collision_monitor {

/// Sums over points.
struct Moments {
  double count{0.0};
  Eigen::Vector3d sum{Eigen::Vector3d::Zero()};
  Eigen::Matrix3d outer{Eigen::Matrix3d::Zero()};  ///< of products of coordinates

  void add(const Eigen::Vector3d& point) {
    count += 1.0;
    sum += point;
    outer += point * point.transpose();
  }
  void add(const Moments& other, double sign = 1.0) {
    count += sign * other.count;
    sum += sign * other.sum;
    outer += sign * other.outer;
  }
  Eigen::Matrix3d covariance() const {
    const Eigen::Vector3d mean = sum / count;
    return outer / count - mean * mean.transpose();
  }
};

/// Summary of many points: the farthest ones, and sums over all.
struct PointSummary {
  Points corners;   ///< the farthest ones
  Moments moments;  ///< of all points
};

/// The size of a set of points.
struct Extent {
  double bulk{0.0};    ///< [m^3] of a box around them plus a box with their scatter
  double length{0.0};  ///< [m] diagonal of the first box
};

/// The first box is the smaller of two: along the axes of the frame, or along those of the scatter.
/// The second tells an L from a block, whose first boxes are equal.
/// @param layer [m] spacing of the samples, added to all sides: so the gap between samples on both
/// sides of a cut counts, and flat sets have a bulk.
/// @pre at least one corner.
Extent extentOf(const PointSummary& summary, double layer);

}  // namespace collision_monitor
