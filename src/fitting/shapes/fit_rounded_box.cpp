// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/shapes/fit_rounded_box.h"

#include <algorithm>

#include "fitting/search/core_set.h"
#include "fitting/search/point_cloud.h"
#include "fitting/search/small_shapes.h"
#include "fitting/shapes/fit_sphere.h"

namespace collision_monitor {
namespace {

// Goals often end in the same place; comparing that result twice is useless.
constexpr double kSame = 0.005;  // of the size, which is 1
// Of a box's half extents. A start that is nearly a box and one that is nearly round find different
// minima.
constexpr double kStartExtents[] = {0.85, 0.5};

// Of the size of the set, which is 1. Without growth a box wins wherever its corners are filled as
// well as the rest. More growth demands more of its corners.
constexpr double kBoxGrowths[] = {0.0, 0.1, 0.3, 1.0};

TurnedCore startFrom(const PosedShape& fit, double fraction, const NormalisedPoints& cloud) {
  TurnedCore core;
  core.rotation = fit.geometry_from_body.rotation;
  core.center = (fit.geometry_from_body.translation - cloud.center) / cloud.scale;
  core.half_extents = fraction / cloud.scale * coreHalfExtents(fit.shape);
  return core;
}

}  // namespace

std::vector<PosedShape> smallRoundedBoxes(const Points& points,
                                          const std::vector<PosedShape>& boxes,
                                          const std::vector<PosedShape>& capsules) {
  const NormalisedPoints cloud = normalise(points);
  if (!(cloud.scale > 0.0)) {
    return {};
  }
  std::vector<TurnedCore> starts;
  for (const auto& box : boxes) {
    for (const double fraction : kStartExtents) {
      starts.push_back(startFrom(box, fraction, cloud));
    }
  }
  starts.push_back(startFrom(capsules.front(), 1.0, cloud));
  const Points representatives = representativesOf(cloud.points);
  std::vector<TurnedCore> cores;
  for (const double growth : kBoxGrowths) {
    DescentGoal goal;
    goal.growth = growth;
    for (const auto& core : descendAll(starts, representatives, cloud.points, goal)) {
      if (std::none_of(cores.begin(), cores.end(),
                       [&](const TurnedCore& other) { return areAlike(core, other, kSame); })) {
        cores.push_back(core);
      }
    }
  }
  std::sort(cores.begin(), cores.end(), IsSmaller{});
  std::vector<PosedShape> fits;
  fits.reserve(cores.size());
  for (const auto& core : cores) {
    fits.push_back(placedInCloud(core, cloud));
  }
  return fits;
}

PosedShape fitRoundedBox(const Points& points) {
  const auto boxes = smallBoxes(points);
  const auto capsules = smallCapsules(points);
  PosedShape best = fitSphere(points);
  for (const auto& fits : {boxes, capsules, smallRoundedBoxes(points, boxes, capsules)}) {
    if (!fits.empty() && volumeOf(fits.front().shape) < volumeOf(best.shape)) {
      best = fits.front();
    }
  }
  best.shape = RoundedBox{coreHalfExtents(best.shape), radiusOf(best.shape)};
  return best;
}

}  // namespace collision_monitor
