// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/search/core_set.h"

#include <algorithm>
#include <cmath>

#include "fitting/search/small_shapes.h"

namespace collision_monitor {
namespace {

// Weights at which valleys are distinguished and ranked. A good core continues from the ranking.
constexpr double kRoughWeight = 300.0;
constexpr double kRankingWeight = 3000.0;
constexpr double kAlike = 0.03;  // of the size, which is 1

/// A start for descend, which needs all points strictly inside and free extents above zero.
TurnedCore withRoom(TurnedCore core, const DescentGoal& goal, const Points& points) {
  // Of the size, which is 1: about what the first weight leaves.
  const double room = goal.first_weight > kRoughWeight ? 0.005 : 0.02;
  for (int k = 0; k < 3; ++k) {
    if (goal.free_extents[k]) {
      core.half_extents[k] = std::max(core.half_extents[k], room);
    }
  }
  core.radius = enclosingRadius(core, points) + room;
  return core;
}

/// Adds the points farthest outside to `subset`. Returns the greatest distance outside.
double addLeftOut(const Points& points, const TurnedCore& core, Points& subset) {
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

/// Descends with one weight for each core; least volume first.
void descendTo(double weight, const Points& points, DescentGoal goal,
               std::vector<TurnedCore>& cores) {
  goal.first_weight = weight;
  goal.last_weight = weight;
  for (auto& core : cores) {
    core = descended(core, points, goal);
  }
  std::sort(cores.begin(), cores.end(), IsSmaller{goal.growth});
}

/// Keeps the first of the cores in one valley, which would end in one place.
std::vector<TurnedCore> distinctOf(const std::vector<TurnedCore>& cores) {
  std::vector<TurnedCore> distinct;
  for (const auto& core : cores) {
    if (std::none_of(distinct.begin(), distinct.end(),
                     [&](const TurnedCore& other) { return areAlike(core, other, kAlike); })) {
      distinct.push_back(core);
    }
  }
  return distinct;
}

}  // namespace

double volumeOf(const TurnedCore& core, double growth) noexcept {
  return volumeOf(RoundedBox{core.half_extents, core.radius + growth});
}

bool areAlike(const TurnedCore& a, const TurnedCore& b, double tolerance) noexcept {
  const auto spread = [](const TurnedCore& core) -> Eigen::Matrix3d {
    const Eigen::Matrix3d halves = core.rotation * core.half_extents.asDiagonal();
    return halves * halves.transpose();
  };
  return (a.center - b.center).norm() + std::abs(a.radius - b.radius) +
             (spread(a) - spread(b)).norm() <
         tolerance;
}

TurnedCore descended(const TurnedCore& start, const Points& points, const DescentGoal& goal) {
  TurnedCore enclosing = start;
  enclosing.radius = enclosingRadius(start, points);
  TurnedCore core = withRoom(start, goal, points);
  descend(points, goal, core);
  core.radius = enclosingRadius(core, points);
  return std::min(enclosing, core, IsSmaller{goal.growth});
}

TurnedCore refineCore(const TurnedCore& start, Points representatives, const Points& points,
                      const DescentGoal& goal) {
  constexpr int kMaxRounds = 5;
  constexpr double kHair = 5e-4;  // of the size, which is 1
  TurnedCore core = start;
  TurnedCore best = start;
  best.radius = enclosingRadius(start, points);
  for (int round = 0; round < kMaxRounds; ++round) {
    if (addLeftOut(points, core, representatives) < kHair && round > 0) {
      break;
    }
    core = descended(core, representatives, goal);
    TurnedCore enclosing = core;
    enclosing.radius = enclosingRadius(core, points);
    best = std::min(best, enclosing, IsSmaller{goal.growth});
  }
  return best;
}

std::vector<TurnedCore> descendAll(std::vector<TurnedCore> starts, const Points& representatives,
                                   const Points& points, const DescentGoal& goal) {
  descendTo(kRoughWeight, representatives, goal, starts);
  std::vector<TurnedCore> fits = distinctOf(starts);
  if (fits.size() > kMaxFits) {
    descendTo(kRankingWeight, representatives, goal, fits);
    fits = distinctOf(fits);
    fits.resize(std::min(fits.size(), kMaxFits));
  }
  DescentGoal fine = goal;
  fine.first_weight = kRankingWeight;
  for (auto& core : fits) {
    core = refineCore(core, representatives, points, fine);
  }
  std::sort(fits.begin(), fits.end(), IsSmaller{goal.growth});
  return fits;
}

PosedShape placedInCloud(const TurnedCore& core, const NormalisedPoints& cloud) {
  return {RoundedBox{cloud.scale * core.half_extents, cloud.scale * core.radius},
          {core.rotation, cloud.center + cloud.scale * core.center}};
}

}  // namespace collision_monitor
