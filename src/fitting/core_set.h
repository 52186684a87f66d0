// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fitting/core_descent.h"
#include "fitting/point_cloud.h"

namespace collision_monitor {

/// The core a little smaller where it may be and the radius a little larger: a start for descend,
/// which needs every point strictly inside and every free extent above zero.
PlacedCore withRoom(PlacedCore core, const FreeExtents& free_extents);

/// The placed core back in the frame and size of the original points.
PosedShape placedInCloud(const PlacedCore& core, const NormalisedPoints& cloud);

/// Adds to `subset` the points that lie farthest outside the core.
/// @return the largest distance by which one lies outside.
double addFarthestOutside(const Points& points, const PlacedCore& core, Points& subset);

/// Fits a few extreme points instead of all, adds those that the fit leaves out, and repeats until
/// none is left out by more than a hair. The radius returned holds all points.
/// Source: Agarwal, Har-Peled, Varadarajan, "Geometric Approximation via Coresets" (2005).
template <class Fit>
PlacedCore fitOnCoreSet(const Points& points, const Fit& fit) {
  constexpr int kMaxRounds = 4;
  constexpr double kHair = 5e-4;  // of the size of the set
  Points subset = extremePoints(points, spreadDirections(kRepresentativeDirections));
  PlacedCore core = fit(subset);
  for (int round = 1; round < kMaxRounds; ++round) {
    if (addFarthestOutside(points, core, subset) < kHair) {
      break;
    }
    core = fit(subset);
  }
  core.radius = enclosingRadius(core, points);
  return core;
}

}  // namespace collision_monitor
