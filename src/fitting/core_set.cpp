// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/core_set.h"

#include <algorithm>

namespace collision_monitor {

PlacedCore withRoom(PlacedCore core, const FreeExtents& free_extents) {
  constexpr double kRoom = 0.02;  // of the size, which is 1
  for (int k = 0; k < 3; ++k) {
    if (free_extents[k]) {
      core.half_extents[k] = std::max(core.half_extents[k], kRoom);
    }
  }
  core.radius += kRoom;
  return core;
}

PosedShape placedInCloud(const PlacedCore& core, const NormalisedPoints& cloud) {
  return {RoundedBox{cloud.scale * core.half_extents, cloud.scale * core.radius},
          {core.rotation, cloud.centre + cloud.scale * core.centre}};
}

double addFarthestOutside(const Points& points, const PlacedCore& core, Points& subset) {
  constexpr std::size_t kMaxAdded = 40;
  const PosedShape fit{RoundedBox{core.half_extents, core.radius}, {core.rotation, core.centre}};
  std::vector<std::pair<double, std::size_t>> outside;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double excess = excessOver(fit, {points[i]});
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

}  // namespace collision_monitor
