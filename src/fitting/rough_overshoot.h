// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "collision_monitor/fitting/overshoot.h"
#include "fitting/core_descent.h"
#include "fitting/distance_grid.h"

namespace collision_monitor {

/// A point of every rounded box: of its core the corner (1, 1, 1) times `fraction`, from there the
/// radius outward. It stands for `share` of its patch.
struct PatternPoint {
  Eigen::Vector3d fraction;
  Eigen::Vector3d outward;
  double share{0.0};
};

/// Points of the faces across x, y, z, of the edges along x, y, z, and of the corners.
using SurfacePattern = std::array<std::vector<PatternPoint>, 7>;
const SurfacePattern& surfacePattern();

/// Areas of one face, edge or corner of each patch.
std::array<double, 7> patchAreas(const PlacedCore& core) noexcept;

/// The overshoot of a core with its radius, from some hundred points and a grid: microseconds,
/// where measureOvershoot takes milliseconds. For searches.
/// Frames: core and grid in the geometry's. Error: that of the grid; spikes narrower than a sixth
/// of the core may be missed.
/// @param counts whether a point of the surface counts.
template <class Counts>
OvershootSum roughOvershoot(const PlacedCore& core, const DistanceGrid& grid,
                            const Counts& counts) noexcept {
  const SurfacePattern& pattern = surfacePattern();
  const auto areas = patchAreas(core);
  const Eigen::Matrix3d stretch = core.rotation * core.half_extents.asDiagonal();
  const Eigen::Matrix3d outward = core.radius * core.rotation;
  OvershootSum sum;
  for (std::size_t patch = 0; patch < pattern.size(); ++patch) {
    if (!(areas[patch] > 0.0)) {
      continue;
    }
    for (const auto& sample : pattern[patch]) {
      const Eigen::Vector3d point =
          core.centre + stretch * sample.fraction + outward * sample.outward;
      // Most points are inside or near, and then it matters little whether they count.
      const double distance = grid.distanceTo(point);
      if (!(distance > 0.0) || counts(point)) {
        sum.add(distance, areas[patch] * sample.share);
      }
    }
  }
  return sum;
}

}  // namespace collision_monitor
