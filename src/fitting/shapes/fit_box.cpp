// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/shapes/fit_box.h"

#include <algorithm>

#include "fitting/search/box_rotations.h"
#include "fitting/search/core_set.h"
#include "fitting/search/point_cloud.h"
#include "fitting/search/small_shapes.h"

namespace collision_monitor {
namespace {

/// Descends on the representatives, adds the points that the box leaves out, and repeats until the
/// box of these is the box of all.
TurnedCore refineBox(Eigen::Matrix3d axes, Points representatives, const Points& points) {
  constexpr int kMaxRounds = 6;
  constexpr double kHair = 1e-4;  // of the volume
  TurnedCore best = boxWithAxes(axes, points);
  for (int round = 0; round < kMaxRounds; ++round) {
    axes = refineBoxRotation(axes, representatives);
    const TurnedCore fit = boxWithAxes(axes, points);
    best = volumeOf(fit) < volumeOf(best) ? fit : best;
    if (volumeOf(fit) <= (1.0 + kHair) * volumeOf(boxWithAxes(axes, representatives))) {
      break;
    }
    Points directions;
    for (int k = 0; k < 3; ++k) {
      directions.emplace_back(axes.col(k));
      directions.emplace_back(-axes.col(k));
    }
    const Points left_out = extremePoints(points, directions);
    representatives.insert(representatives.end(), left_out.begin(), left_out.end());
  }
  return best;
}

}  // namespace

std::vector<PosedShape> smallBoxes(const Points& points) {
  const NormalisedPoints cloud = normalise(points);
  if (!(cloud.scale > 0.0)) {
    return {{Box{}, {Eigen::Matrix3d::Identity(), points[0]}}};
  }
  const Points representatives = representativesOf(cloud.points);
  std::vector<TurnedCore> cores;
  for (const auto& axes : smallBoxRotations(representatives, kMaxFits)) {
    cores.push_back(refineBox(axes, representatives, cloud.points));
  }
  std::sort(cores.begin(), cores.end(), IsSmaller{});
  std::vector<PosedShape> fits;
  for (const auto& core : cores) {
    const PosedShape fit = placedInCloud(core, cloud);
    fits.push_back({Box{coreHalfExtents(fit.shape)}, fit.geometry_from_body});
  }
  return fits;
}

PosedShape fitBox(const Points& points) { return smallBoxes(points).front(); }

}  // namespace collision_monitor
