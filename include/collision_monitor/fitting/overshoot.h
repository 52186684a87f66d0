// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "collision_monitor/fitting/posed_shape.h"
#include "collision_monitor/geometry/triangle_bvh.h"

namespace collision_monitor {

/// How far the surface of an enclosing shape lies outside the geometry it encloses: the distance
/// from a point of the shape's surface to the nearest point of the geometry's surface. That point
/// lies outside the geometry because the shape encloses it, so this needs no inside and outside of
/// the mesh: open, inverted and self-intersecting meshes are measured like any other.
///
/// Units: metres. Means are over the area of the shape.
struct Overshoot {
  double max{0.0};
  double mean{0.0};
  /// Fourth root of the mean of the fourth power: between mean and max, by area and by height.
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
  void add(double distance, double area) noexcept {
    max_ = std::max(max_, distance);
    area_ += area;
    first_moment_ += area * distance;
    const double squared = distance * distance;
    fourth_moment_ += area * squared * squared;
  }
  void add(const OvershootSum& other) noexcept;
  Overshoot total() const noexcept;

 private:
  double max_{0.0};
  double area_{0.0};
  double first_moment_{0.0};
  double fourth_moment_{0.0};
};

/// Points on a grid over the shape's faces, edges and corners, borders included; the same ones
/// every time. Neighbours are at most sqrt(area / count) apart along each direction of the grid, so
/// there are about `count`, and never fewer than one a corner.
std::vector<SurfaceSample> sampleSurface(const Shape& shape, int count);

/// How closely overshoot is measured.
struct OvershootSampling {
  int count{1000};         ///< samples, about
  double tolerance{0.01};  ///< a distance to the mesh may come out too large by this fraction
};

/// Overshoot over a mesh.
/// Error: `max` may be too small by the distance between samples over sqrt(2), and everything too
/// large by the fraction `tolerance`.
Overshoot measureOvershoot(const PosedShape& fit, const TriangleBvh& mesh,
                           const OvershootSampling& sampling = {});

}  // namespace collision_monitor
