// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/core_set.h"

#include <algorithm>

#include "fitting/small_shapes.h"

namespace collision_monitor {
namespace {

/// A start for descend, which needs every point strictly inside and every free extent above zero.
PlacedCore withRoom(PlacedCore core, const FreeExtents& free_extents, const Points& points) {
  constexpr double kRoom = 0.02;  // of the size, which is 1
  for (int k = 0; k < 3; ++k) {
    if (free_extents[k]) {
      core.half_extents[k] = std::max(core.half_extents[k], kRoom);
    }
  }
  core.radius = enclosingRadius(core, points) + kRoom;
  return core;
}

/// Adds the points that lie farthest outside to `subset`; returns the largest distance outside.
double addLeftOut(const Points& points, const PlacedCore& core, Points& subset) {
  constexpr std::size_t kMaxAdded = 20;
  std::vector<std::pair<double, std::size_t>> outside;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double excess = distanceToCore(core, points[i]) - core.radius;
    if (excess > 0.0) {
      outside.emplace_back(-excess, i);
    }
  }
  std::sort(outside.begin(), outside.end());
  for (std::size_t i = 0; i < std::min(outside.size(), kMaxAdded); ++i) {
    subset.push_back(points[outside[i].second]);
  }
  return outside.empty() ? 0.0 : -outside.front().first;
}

}  // namespace

double volumeOf(const PlacedCore& core, double growth) noexcept {
  return volumeOf(RoundedBox{core.half_extents, core.radius + growth});
}

PlacedCore descended(const PlacedCore& start, const Points& points, const DescentGoal& goal) {
  PlacedCore enclosing = start;
  enclosing.radius = enclosingRadius(start, points);
  PlacedCore core = withRoom(start, goal.free_extents, points);
  descend(points, goal, core);
  return std::min(enclosing, core, IsSmaller{goal.growth});
}

PlacedCore refineCore(const PlacedCore& start, Points representatives, const Points& points,
                      const DescentGoal& goal) {
  constexpr int kMaxRounds = 5;
  constexpr double kHair = 5e-4;  // of the size, which is 1
  PlacedCore core = start;
  PlacedCore best = start;
  best.radius = enclosingRadius(start, points);
  for (int round = 0; round < kMaxRounds; ++round) {
    if (addLeftOut(points, core, representatives) < kHair) {
      break;
    }
    core = descended(core, representatives, goal);
    PlacedCore enclosing = core;
    enclosing.radius = enclosingRadius(core, points);
    best = std::min(best, enclosing, IsSmaller{goal.growth});
  }
  return best;
}

std::vector<PlacedCore> descendAll(std::vector<PlacedCore> starts, const Points& points,
                                   const DescentGoal& goal) {
  const Points representatives = representativesOf(points);
  for (auto& core : starts) {
    core = descended(core, representatives, goal);
  }
  std::sort(starts.begin(), starts.end(), IsSmaller{goal.growth});
  std::vector<PlacedCore> fits;
  for (const auto& core : starts) {
    // Starts in one valley end at one volume; the same fit twice is of no use.
    constexpr double kSame = 1.001;
    if (fits.size() < kMaxFits &&
        (fits.empty() ||
         volumeOf(core, goal.growth) > kSame * volumeOf(fits.back(), goal.growth))) {
      fits.push_back(core);
    }
  }
  for (auto& core : fits) {
    core = refineCore(core, representatives, points, goal);
  }
  std::sort(fits.begin(), fits.end(), IsSmaller{goal.growth});
  return fits;
}

PosedShape placedInCloud(const PlacedCore& core, const NormalisedPoints& cloud) {
  return {RoundedBox{cloud.scale * core.half_extents, cloud.scale * core.radius},
          {core.rotation, cloud.centre + cloud.scale * core.centre}};
}

}  // namespace collision_monitor
