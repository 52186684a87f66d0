// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "fitting/search/core_descent.h"
#include "fitting/search/pattern_lanes.h"

namespace collision_monitor {

/// Some points of a surface, in rows. Numbers beyond the last point are read and mean nothing.
struct PointRows {
  static constexpr std::size_t kMost = PatternRows::kMost;

  alignas(64) double at[3][kMost]{};
  std::size_t count{0};

  void add(const Eigen::Vector3d& point) noexcept {
    for (int axis = 0; axis < 3; ++axis) {
      at[axis][count] = point[axis];
    }
    ++count;
  }
};

/// Of many cores, those that may hold a point of another core's surface. Most are far away, and a
/// search tests hundreds of points.
class NearCores {
 public:
  /// @param slack [m] greatest distance of points from the surface
  /// @pre `all` outlives this.
  NearCores(const std::vector<TurnedCore>& all, const TurnedCore& core, double slack);

  /// Marks the points that are strictly inside one of the cores, inflated by its radius. Uses the
  /// widest vector instructions of the machine; all give the same answer.
  void mark(const PointRows& points,
            std::array<unsigned char, PointRows::kMost>& is_held) const noexcept;

 private:
  std::vector<const TurnedCore*> near_;
};

}  // namespace collision_monitor
