// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace collision_monitor {

/// Points of every rounded box, in rows. A point is the core's corner (1, 1, 1) times `fraction`,
/// moved by the radius along `outward`.
struct PatternRows {
  static constexpr std::size_t kMost = 80;  ///< a multiple of all register widths

  alignas(64) float fraction[3][kMost]{};
  alignas(64) float outward[3][kMost]{};
  std::size_t count{0};
};

/// Maps a point's fraction and outward direction into a grid.
struct PatternFrame {
  float center[3];
  float of_fraction[3][3];  ///< columns
  float of_outward[3][3];
};

/// The numbers of a DistanceGrid.
struct GridRows {
  const float* distance;
  int size_x;
  int size_xy;
  float last[3];
};

/// The places of the points in the grid and the distances there. Undefined beyond the last point.
struct PatternPlaces {
  alignas(64) float place[3][PatternRows::kMost];
  alignas(64) float distance[PatternRows::kMost];
};

/// As DistanceGrid::distanceAt for each point, many at once. Rounds alike on all machines.
void placePattern(const PatternRows& rows, const PatternFrame& frame, const GridRows& grid,
                  PatternPlaces& places) noexcept;

}  // namespace collision_monitor
