// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/fitting/fit_rounded_box.h"

#include <algorithm>

#include "collision_monitor/fitting/fit_box.h"
#include "collision_monitor/fitting/fit_capsule.h"
#include "collision_monitor/fitting/fit_sphere.h"
#include "fitting/box_rotations.h"
#include "fitting/core_descent.h"
#include "fitting/core_set.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kBoxStarts = 4;
// A start that is nearly a box and one that is nearly round find different minima.
constexpr double kStartExtents[] = {0.85, 0.5};

double volume(const PlacedCore& core) {
  return volumeOf(RoundedBox{core.half_extents, core.radius});
}

PlacedCore smallestRoundedBox(const Points& points) {
  PlacedCore best;
  best.radius = 2.0;  // holds every normalised set
  for (const auto& rotation : smallBoxRotations(points, kBoxStarts)) {
    const PosedShape box = boxWithAxes(rotation, points);
    for (const double fraction : kStartExtents) {
      PlacedCore core;
      core.rotation = rotation;
      core.centre = box.geometry_from_body.translation;
      core.half_extents = fraction * coreHalfExtents(box.shape);
      core.radius = enclosingRadius(core, points);
      core = withRoom(core, {true, true, true});
      descend(points, {true, true, true}, core);
      if (volume(core) < volume(best)) {
        best = core;
      }
    }
  }
  return best;
}

}  // namespace

PosedShape fitRoundedBox(const Points& points) {
  const NormalisedPoints cloud = normalise(points);
  PosedShape best = fitBox(points);
  const auto consider = [&](const PosedShape& fit) {
    best = volumeOf(fit.shape) < volumeOf(best.shape) ? fit : best;
  };
  consider(fitCapsule(points));
  consider(fitSphere(points));
  if (cloud.scale > 0.0) {
    consider(placedInCloud(fitOnCoreSet(cloud.points, smallestRoundedBox), cloud));
  }
  best.shape = RoundedBox{coreHalfExtents(best.shape), radiusOf(best.shape)};
  return best;
}

}  // namespace collision_monitor
