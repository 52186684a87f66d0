// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fits_long_search.h"

#include <algorithm>
#include <cmath>

#include "fitting/search/box_rotations.h"
#include "fitting/search/core_set.h"
#include "fitting/search/point_cloud.h"
#include "fitting/shapes/fit_box.h"
#include "fitting/shapes/fit_capsule.h"
#include "fitting/shapes/fit_rounded_box.h"
#include "fitting/shapes/fit_sphere.h"

namespace collision_monitor::test {
namespace {

double longCapsule(const NormalisedPoints& cloud, int starts) {
  double best = INFINITY;
  const Points spread = spreadDirections(starts);
  const Points representatives = representativesOf(cloud.points);
  for (int i = 0; i < starts; ++i) {
    TurnedCore core;
    core.rotation = rotationWithAxis(spread[static_cast<std::size_t>(i)]);
    core.half_extents.z() = 0.1 + 0.7 * (i % 7) / 7.0;
    const DescentGoal goal{{false, false, true}, 0.0};
    core = refineCore(descended(core, representatives, goal), representatives, cloud.points, goal);
    best = std::min(best, volumeOf(core));
  }
  return best;
}

double longBox(const NormalisedPoints& cloud, int starts) {
  double best = INFINITY;
  for (const auto& rotation : spreadRotations(starts)) {
    const auto axes = refineBoxRotation(rotation, cloud.points);
    best = std::min(best, volumeOf(boxWithAxes(axes, cloud.points)));
  }
  return best;
}

double longRoundedBox(const NormalisedPoints& cloud, int starts) {
  double best = INFINITY;
  const Points representatives = representativesOf(cloud.points);
  const DescentGoal goal{{true, true, true}, 0.0};
  int i = 0;
  for (const auto& rotation : spreadRotations(starts)) {
    TurnedCore core = boxWithAxes(rotation, cloud.points);
    core.half_extents *= 0.2 + 0.7 * (i++ % 5) / 5.0;
    core = refineCore(descended(core, representatives, goal), representatives, cloud.points, goal);
    best = std::min(best, volumeOf(core));
  }
  return best;
}

}  // namespace

VolumeRatios compareVolumes(const TriangleMesh& mesh, int starts) {
  const Points corners = outerPoints(mesh.vertices);
  const NormalisedPoints cloud = normalise(corners);
  const double cube = std::pow(cloud.scale, 3);
  const double box = volumeOf(fitBox(corners).shape) / cube;
  VolumeRatios ratios;
  ratios.corners = corners.size();
  if (starts == 0 || !(box > 1e-9)) {  // the ratio of two zeros says nothing
    return ratios;
  }
  const double sphere = volumeOf(fitSphere(corners).shape) / cube;
  const double capsule = volumeOf(fitCapsule(corners).shape) / cube;
  const double rounded = volumeOf(fitRoundedBox(corners).shape) / cube;
  ratios.capsule = capsule / longCapsule(cloud, starts);
  ratios.box = box / longBox(cloud, starts);
  ratios.rounded_box = rounded / std::min(rounded, longRoundedBox(cloud, starts));
  ratios.rounded_over_others = rounded / std::min({sphere, capsule, box});
  return ratios;
}

}  // namespace collision_monitor::test
