// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "collision_monitor/fitting/overshoot.h"
#include "fitting/core_descent.h"
#include "fitting/distance_grid.h"

namespace collision_monitor {

/// A point of every rounded box: of its core the corner (1, 1, 1) times `fraction`, from there the
/// radius outward. It stands for `share` of its patch.
struct PatternPoint {
  Eigen::Vector3f fraction;
  Eigen::Vector3f outward;
  double share{0.0};
};

/// Points of the faces across x, y, z, of the edges along x, y, z, and of the corners.
using SurfacePattern = std::array<std::vector<PatternPoint>, 7>;
const SurfacePattern& surfacePattern();

/// Areas of one face, edge or corner of each patch.
std::array<double, 7> patchAreas(const PlacedCore& core) noexcept;

/// Columns that take a point's fraction, and its way outward, into the grid.
inline Eigen::Matrix<float, 4, 6> patternInGrid(const PlacedCore& core,
                                                const DistanceGrid& grid) noexcept {
  Eigen::Matrix<float, 4, 6> columns = Eigen::Matrix<float, 4, 6>::Zero();
  const Eigen::Matrix3d in_grid = grid.nodesPerMetre() * core.rotation;
  columns.topLeftCorner<3, 3>() = (in_grid * core.half_extents.asDiagonal()).cast<float>();
  columns.topRightCorner<3, 3>() = (core.radius * in_grid).cast<float>();
  return columns;
}

/// The overshoot of a core with its radius, from some hundred points and a grid: microseconds,
/// where measureOvershoot takes milliseconds. For searches.
/// Frames: core and grid in the geometry's. Error: that of the grid; spikes narrower than a sixth
/// of the core may be missed.
/// @param counts whether a point of the surface counts.
/// @param is_enough is asked after each patch, with a sum whose figures those of the whole cannot
/// fall below, whether that will do; then it is returned.
template <class Counts, class IsEnough>
OvershootSum roughOvershoot(const PlacedCore& core, const DistanceGrid& grid, const Counts& counts,
                            const IsEnough& is_enough) noexcept {
  const SurfacePattern& pattern = surfacePattern();
  const auto areas = patchAreas(core);
  const DistanceGrid::Place centre = grid.inGrid(core.centre);
  const Eigen::Matrix<float, 4, 6> columns = patternInGrid(core, grid);
  constexpr double kCopies[] = {2.0, 2.0, 2.0, 4.0, 4.0, 4.0, 8.0};
  double rest = 0.0;
  for (std::size_t patch = 0; patch < pattern.size(); ++patch) {
    rest += kCopies[patch] * areas[patch];
  }
  OvershootSum sum;
  // The corners first: they stick out farthest.
  for (std::size_t patch = pattern.size(); patch-- > 0;) {
    if (!(areas[patch] > 0.0)) {
      continue;
    }
    rest -= kCopies[patch] * areas[patch];
    for (const auto& sample : pattern[patch]) {
      DistanceGrid::Place place = centre;
      for (Eigen::Index k = 0; k < 3; ++k) {
        place += columns.col(k).array() * sample.fraction[k] +
                 columns.col(k + 3).array() * sample.outward[k];
      }
      // Most points are inside or near, and then it matters little whether they count.
      const float distance = grid.distanceAt(place);
      if (!(distance > 0.0f) || counts(grid.outOfGrid(place))) {
        sum.add(grid.spacing() * static_cast<double>(distance), areas[patch] * sample.share);
      }
    }
    OvershootSum least = sum;
    least.add(0.0, std::max(rest, 0.0));
    if (is_enough(least)) {
      return least;
    }
  }
  return sum;
}

}  // namespace collision_monitor
