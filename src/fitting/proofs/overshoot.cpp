// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/fitting/overshoot.h"

#include <algorithm>
#include <cmath>

#include "collision_monitor/geometry/ids.h"
#include "geometry/constants.h"
#include "geometry/interruption.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

constexpr double kLeastSteps = 2.0;

/// Visits a grid over a patch with parameters in [0, 1]^2, borders included. The weights are those
/// of the trapezoid rule; their sum is 1.
template <class Visit>
void visitGrid(int u_steps, int v_steps, const Visit& visit) {
  const auto weight = [](int i, int steps) {
    return (i == 0 || i == steps ? 0.5 : 1.0) / static_cast<double>(steps);
  };
  for (int i = 0; i <= u_steps; ++i) {
    for (int j = 0; j <= v_steps; ++j) {
      visit(static_cast<double>(i) / u_steps, static_cast<double>(j) / v_steps,
            weight(i, u_steps) * weight(j, v_steps));
    }
  }
}

/// Collects the samples of one rounded box.
class SurfaceSampler {
 public:
  SurfaceSampler(const Shape& shape, int count)
      : half_extents_(coreHalfExtents(shape)),
        radius_(radiusOf(shape)),
        most_work_(std::max(count / 4.0, kLeastSteps)) {
    const Vector3d& h = half_extents_;
    const double faces = 8.0 * (h.x() * h.y() + h.y() * h.z() + h.z() * h.x());
    const double area = faces + 4.0 * kHalfPi * radius_ * (h.sum() + 2.0 * radius_);
    spacing_ = std::sqrt(area / count);
  }

  std::vector<SurfaceSample> sample() {
    for (int signs = 0; signs < 8; ++signs) {
      addCorner({side(signs & 1), side(signs & 2), side(signs & 4)});
    }
    for (int k = 0; k < 3; ++k) {
      for (int signs = 0; signs < 4; ++signs) {
        addEdge(k, side(signs & 1), side(signs & 2));
      }
      addFace(k, -1.0);
      addFace(k, 1.0);
    }
    return std::move(samples_);
  }

 private:
  static double side(int bit) { return bit != 0 ? 1.0 : -1.0; }

  /// The number of steps along a length, limited: needles would get millions at this spacing.
  int stepCount(double length) const {
    return static_cast<int>(std::clamp(std::ceil(length / spacing_), kLeastSteps, most_work_));
  }

  void add(const Vector3d& point, double area) { samples_.push_back({point, area}); }

  /// An eighth of a sphere in spherical angles; a single point if the radius is 0.
  void addCorner(const Vector3d& signs) {
    const Vector3d corner = signs.cwiseProduct(half_extents_);
    if (!(radius_ > 0.0)) {
      add(corner, 0.0);
      return;
    }
    const int steps = stepCount(kHalfPi * radius_);
    visitGrid(steps, steps, [&](double u, double v, double weight) {
      const double polar = kHalfPi * u;
      const double azimuth = kHalfPi * v;
      const Vector3d outward(std::sin(polar) * std::cos(azimuth),
                             std::sin(polar) * std::sin(azimuth), std::cos(polar));
      const double area = kHalfPi * kHalfPi * radius_ * radius_ * std::sin(polar) * weight;
      add(corner + radius_ * signs.cwiseProduct(outward), area);
    });
  }

  /// A quarter of a cylinder along axis k.
  void addEdge(int k, double sign_u, double sign_v) {
    const double length = 2.0 * half_extents_[k];
    if (!(length > 0.0) || !(radius_ > 0.0)) {
      return;
    }
    const int axis_u = (k + 1) % 3;
    const int axis_v = (k + 2) % 3;
    const double arc = kHalfPi * radius_;
    visitGrid(stepCount(length), stepCount(arc), [&](double u, double v, double weight) {
      Vector3d point;
      point[k] = (u - 0.5) * length;
      point[axis_u] = sign_u * (half_extents_[axis_u] + radius_ * std::cos(kHalfPi * v));
      point[axis_v] = sign_v * (half_extents_[axis_v] + radius_ * std::sin(kHalfPi * v));
      add(point, length * arc * weight);
    });
  }

  /// A flat rectangle across axis k.
  void addFace(int k, double sign) {
    const int axis_u = (k + 1) % 3;
    const int axis_v = (k + 2) % 3;
    const double length_u = 2.0 * half_extents_[axis_u];
    const double length_v = 2.0 * half_extents_[axis_v];
    if (!(length_u * length_v > 0.0)) {
      return;
    }
    visitGrid(stepCount(length_u), stepCount(length_v), [&](double u, double v, double weight) {
      Vector3d point;
      point[k] = sign * (half_extents_[k] + radius_);
      point[axis_u] = (u - 0.5) * length_u;
      point[axis_v] = (v - 0.5) * length_v;
      add(point, length_u * length_v * weight);
    });
  }

  Vector3d half_extents_;
  double radius_;
  double most_work_;
  double spacing_{0.0};
  std::vector<SurfaceSample> samples_;
};

}  // namespace

std::vector<SurfaceSample> sampleSurface(const Shape& shape, int count) {
  return SurfaceSampler(shape, count).sample();
}

void OvershootSum::add(const OvershootSum& other) noexcept {
  max_ = std::max(max_, other.max_);
  area_ += other.area_;
  first_moment_ += other.first_moment_;
  fourth_moment_ += other.fourth_moment_;
}

Overshoot OvershootSum::total() const noexcept {
  // A shape without area has few samples; the worst of them stands for all.
  if (!(area_ > 0.0)) {
    return {max_, max_, max_};
  }
  return {max_, first_moment_ / area_, std::sqrt(std::sqrt(fourth_moment_ / area_))};
}

Overshoot measureOvershoot(const PosedShape& fit, const TriangleBvh& mesh,
                           const OvershootSampling& sampling) {
  OvershootSum sum;
  NearestPoint nearest;
  for (const auto& sample : sampleSurface(fit.shape, sampling.count)) {
    throwIfInterrupted();
    const Vector3d point = fit.geometry_from_body * sample.point;
    // The triangle nearest to the last sample bounds the search, as samples follow neighbours.
    const NearestPoint start = nearest.leaf_triangle == kNone
                                   ? NearestPoint{}
                                   : mesh.nearestOn(nearest.leaf_triangle, point);
    nearest = mesh.nearestTo(point, start, sampling.tolerance);
    sum.add(nearest.distance, sample.area);
  }
  return sum.total();
}

}  // namespace collision_monitor
