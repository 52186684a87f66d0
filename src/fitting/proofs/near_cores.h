// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "fitting/search/core_descent.h"

namespace collision_monitor {

/// Of many cores, those that may hold a point of another core's surface. Most are far away, and a
/// search tests hundreds of points.
class NearCores {
 public:
  /// @param slack [m] greatest distance of points from the surface
  /// @pre `all` outlives this.
  NearCores(const std::vector<TurnedCore>& all, const TurnedCore& core, double slack) noexcept
      : all_(all) {
    const double reach = reachOf(core) + slack;
    for (const TurnedCore& other : all) {
      if (distanceTo(other, core.center) <= kRounding * (reach + other.radius)) {
        if (count_ == near_.size()) {
          is_full_ = true;
          return;
        }
        const double own = kRounding * reachOf(other);
        near_[count_++] = {&other, own * own};
      }
    }
  }

  /// Whether the point is strictly inside one of the cores, inflated by its radius.
  bool hold(const Eigen::Vector3d& point) const noexcept {
    if (is_full_) {
      return std::any_of(all_.begin(), all_.end(),
                         [&](const TurnedCore& core) { return holds(core, point); });
    }
    return std::any_of(near_.begin(), near_.begin() + count_, [&](const Near& near) {
      return (point - near.core->center).squaredNorm() <= near.squared_reach &&
             holds(*near.core, point);
    });
  }

 private:
  static constexpr double kRounding = 1.0 + 1e-9;
  static constexpr std::size_t kMost = 16;

  struct Near {
    const TurnedCore* core{nullptr};
    double squared_reach{0.0};  ///< [m^2] squared bounding radius about its center
  };

  static Eigen::Vector3d beyond(const TurnedCore& core, const Eigen::Vector3d& point) noexcept {
    return (core.rotation.transpose() * (point - core.center)).cwiseAbs() - core.half_extents;
  }
  static double reachOf(const TurnedCore& core) noexcept {
    return core.half_extents.norm() + core.radius;
  }
  /// [m] From the core without its radius.
  static double distanceTo(const TurnedCore& core, const Eigen::Vector3d& point) noexcept {
    return beyond(core, point).cwiseMax(0.0).norm();
  }
  static bool holds(const TurnedCore& core, const Eigen::Vector3d& point) noexcept {
    const Eigen::Vector3d out = beyond(core, point);
    return out.maxCoeff() < 0.0 || out.cwiseMax(0.0).squaredNorm() < core.radius * core.radius;
  }

  const std::vector<TurnedCore>& all_;
  std::array<Near, kMost> near_;
  std::size_t count_{0};
  bool is_full_{false};  ///< there are more than fit: all cores are tested
};

}  // namespace collision_monitor
