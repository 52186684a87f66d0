// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>

#include "collision_monitor/fitting/overshoot.h"
#include "fitting/proofs/distance_grid.h"
#include "fitting/proofs/near_cores.h"
#include "fitting/search/core_descent.h"
#include "fitting/search/pattern_lanes.h"

namespace collision_monitor {

/// Points on one patch of every rounded box, each with its share of the patch's area.
struct PatternPatch {
  PatternRows rows;
  std::array<double, PatternRows::kMost> share{};
};

/// Patches: the faces across x, y, z, the edges along x, y, z, and the corners.
using SurfacePattern = std::array<PatternPatch, 7>;
const SurfacePattern& surfacePattern();

/// The area of one face, edge or corner of each patch.
std::array<double, 7> patchAreas(const TurnedCore& core) noexcept;

/// Takes the pattern of a core into the grid.
PatternFrame patternInGrid(const TurnedCore& core, const DistanceGrid& grid) noexcept;

/// The overshoot of a core with its radius, from some hundred points and a grid. For searches: it
/// takes microseconds where measureOvershoot takes milliseconds.
/// Frames: core and grid in the geometry's frame. Error: that of the grid. Spikes narrower than a
/// sixth of the core may be missed.
/// @param skip marks points of the surface that do not count: skip(points, is_skipped).
/// @param reaches_cutoff called after each patch with a lower bound of the final sum. If it returns
/// true, that bound is the result.
template <class Skip, class ReachesCutoff>
OvershootSum roughOvershoot(const TurnedCore& core, const DistanceGrid& grid, const Skip& skip,
                            const ReachesCutoff& reaches_cutoff) {
  const SurfacePattern& pattern = surfacePattern();
  const auto areas = patchAreas(core);
  const PatternFrame frame = patternInGrid(core, grid);
  const GridRows rows = grid.rows();
  PatternPlaces places;
  PointRows points;
  std::array<unsigned char, PointRows::kMost> is_skipped;
  constexpr double kCopies[] = {2.0, 2.0, 2.0, 4.0, 4.0, 4.0, 8.0};
  double rest = 0.0;
  for (std::size_t patch = 0; patch < pattern.size(); ++patch) {
    rest += kCopies[patch] * areas[patch];
  }
  OvershootSum sum;
  // Corners come first, because they stick out farthest.
  for (std::size_t patch = pattern.size(); patch-- > 0;) {
    if (!(areas[patch] > 0.0)) {
      continue;
    }
    rest -= kCopies[patch] * areas[patch];
    placePattern(pattern[patch].rows, frame, rows, places);
    const std::size_t count = pattern[patch].rows.count;
    // Most points are inside or near, where it matters little whether they count.
    points.count = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (places.distance[i] > 0.0F) {
        points.add(
            grid.outOfGrid({places.place[0][i], places.place[1][i], places.place[2][i], 0.0F}));
      }
    }
    skip(points, is_skipped);
    std::size_t outside = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const float distance = places.distance[i];
      if (!(distance > 0.0F) || is_skipped[outside++] == 0) {
        sum.add(grid.spacing() * static_cast<double>(distance),
                areas[patch] * pattern[patch].share[i]);
      }
    }
    OvershootSum least = sum;
    least.add(0.0, std::max(rest, 0.0));
    if (reaches_cutoff(least)) {
      return least;
    }
  }
  return sum;
}

}  // namespace collision_monitor
