// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/parts/slabs.h"

#include <algorithm>
#include <cmath>

#include "fitting/search/point_cloud.h"

namespace collision_monitor {

std::vector<Eigen::Vector3d> distinctAxes(const std::vector<Eigen::Matrix3d>& frames) {
  constexpr double kSameAxis = 0.97;
  std::vector<Eigen::Vector3d> axes;
  for (const auto& frame : frames) {
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d axis = frame.col(k);
      if (std::none_of(axes.begin(), axes.end(), [&](const Eigen::Vector3d& other) {
            return std::abs(axis.dot(other)) > kSameAxis;
          })) {
        axes.push_back(axis);
      }
    }
  }
  return axes;
}

Slabs::Slabs(const Points& samples, const Eigen::Vector3d& axis) : samples_(&samples), axis_(axis) {
  low_ = std::numeric_limits<double>::infinity();
  double high = -low_;
  for (const auto& sample : samples) {
    low_ = std::min(low_, axis.dot(sample));
    high = std::max(high, axis.dot(sample));
  }
  thickness_ = (high - low_) / kCount;
  if (!canBeCut()) {
    return;
  }
  for (std::uint32_t i = 0; i < samples.size(); ++i) {
    add(i, slabs_[slabOf(samples[i])]);
  }
}

std::size_t Slabs::slabOf(const Eigen::Vector3d& sample) const noexcept {
  const double height = (axis_.dot(sample) - low_) / thickness_;
  return static_cast<std::size_t>(std::clamp(static_cast<int>(height), 0, kCount - 1));
}

void Slabs::Extremes::add(const Extremes& other) {
  for (std::size_t i = 0; i < reach.size(); ++i) {
    if (other.reach[i] > reach[i]) {
      reach[i] = other.reach[i];
      point[i] = other.point[i];
    }
  }
}

void Slabs::add(std::uint32_t sample, Extremes& extremes) const {
  static const Points directions = spreadDirections(kDirections);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const double reach = directions[i].dot((*samples_)[sample]);
    if (reach > extremes.reach[i]) {
      extremes.reach[i] = reach;
      extremes.point[i] = sample;
    }
  }
}

Points Slabs::pointsOf(int first, int last) const {
  Extremes extremes;
  for (int i = first; i < last; ++i) {
    extremes.add(slabs_[static_cast<std::size_t>(i)]);
  }
  Points points;
  if (!std::isfinite(extremes.reach[0])) {
    return points;
  }
  auto& chosen = extremes.point;
  std::sort(chosen.begin(), chosen.end());
  const auto end = std::unique(chosen.begin(), chosen.end());
  for (auto sample = chosen.begin(); sample != end; ++sample) {
    points.push_back((*samples_)[*sample]);
  }
  return points;
}

}  // namespace collision_monitor
