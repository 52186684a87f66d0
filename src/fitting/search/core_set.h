// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "fitting/search/core_descent.h"
#include "fitting/search/point_cloud.h"

namespace collision_monitor {

double volumeOf(const TurnedCore& core, double growth = 0.0) noexcept;

/// Orders cores by their grown volume.
struct IsSmaller {
  double growth{0.0};
  bool operator()(const TurnedCore& a, const TurnedCore& b) const noexcept {
    return volumeOf(a, growth) < volumeOf(b, growth);
  }
};

/// Whether two cores have nearly the same center, radius and half extents along the same axes. The
/// order of the axes does not matter.
bool areAlike(const TurnedCore& a, const TurnedCore& b, double tolerance) noexcept;

/// descend from any core: it is made to enclose first. The grown volume never increases.
TurnedCore descended(const TurnedCore& start, const Points& points, const DescentGoal& goal);

/// Descends on the representatives, adds the points that the fit leaves out, and repeats until none
/// is left out by more than a hair. The returned radius holds all points.
/// Source: Agarwal, Har-Peled, Varadarajan, "Geometric Approximation via Coresets" (2005).
TurnedCore refineCore(const TurnedCore& start, Points representatives, const Points& points,
                      const DescentGoal& goal);

/// Descends from every start: first only far enough to tell valleys apart, then to the bottom of
/// the deepest few. Least volume first.
std::vector<TurnedCore> descendAll(std::vector<TurnedCore> starts, const Points& representatives,
                                   const Points& points, const DescentGoal& goal);

/// The placed core in the frame and size of the original points.
PosedShape placedInCloud(const TurnedCore& core, const NormalisedPoints& cloud);

}  // namespace collision_monitor
