// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "collision_monitor/fitting/posed_shape.h"
#include "collision_monitor/geometry/triangle_bvh.h"

namespace collision_monitor {

/// How far the surface of an enclosing shape lies outside the geometry: the distance from a point
/// of the shape's surface to the nearest point of the geometry's surface. The shape encloses the
/// geometry, so no point of its surface is inside. The mesh therefore needs no inside: open,
/// inverted and self-intersecting meshes are measured like any other.
///
/// Units: metres. Means are over the area of the shape.
struct Overshoot {
  double max{0.0};   ///< the farthest point
  double mean{0.0};  ///< over the area of the shape
  /// Fourth root of the mean of the fourth power. Lies between mean and max: area and height count.
  double fourth_power_mean{0.0};
};

/// A point of a shape's surface and the area it stands for.
struct SurfaceSample {
  Eigen::Vector3d point;  ///< body frame
  double area{0.0};       ///< [m^2]
};

/// Gathers overshoot sample by sample.
class OvershootSum {
 public:
  /// Adds a sample that lies `distance` [m] outside and stands for `area` [m^2].
  void add(double distance, double area) noexcept {
    max_ = std::max(max_, distance);
    area_ += area;
    first_moment_ += area * distance;
    const double squared = distance * distance;
    fourth_moment_ += area * squared * squared;
  }
  void add(const OvershootSum& other) noexcept;  ///< adds all samples of another sum
  /// The overshoot of all samples so far; zeros if their area is 0.
  Overshoot total() const noexcept;

 private:
  double max_{0.0};
  double area_{0.0};
  double first_moment_{0.0};
  double fourth_moment_{0.0};
};

/// Samples the shape's faces, edges and corners on a grid, borders included; always the same
/// points. Neighbours are at most sqrt(area / count) apart along each direction of the grid. So
/// there are about `count` samples, at least one per corner.
std::vector<SurfaceSample> sampleSurface(const Shape& shape, int count);

/// Accuracy of an overshoot measurement.
struct OvershootSampling {
  int count{1000};         ///< approximate number of samples
  double tolerance{0.01};  ///< a distance to the mesh may be too large by this fraction
};

/// Measures the overshoot of a fit over a mesh.
/// Error: `max` may be too small by the distance between samples over sqrt(2). All values may be
/// too large by the fraction `tolerance`.
Overshoot measureOvershoot(const PosedShape& fit, const TriangleBvh& mesh,
                           const OvershootSampling& sampling = {});

}  // namespace collision_monitor
