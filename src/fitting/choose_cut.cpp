// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/choose_cut.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "collision_monitor/geometry/convex_hull.h"
#include "fitting/point_cloud.h"
#include "fitting/slabs.h"

namespace collision_monitor {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int kFirstStep = 16;           // of these, between the places that are looked at first
constexpr std::ptrdiff_t kPolished = 4;  // axes whose best cuts are compared closely
constexpr double kSameAxis = 0.97;
constexpr double kWorthIt = 0.9;  // of the cost before the cut

/// Axes of the frames, of which no two are nearly the same.
std::vector<Vector3d> axesOf(const std::vector<Matrix3d>& frames) {
  std::vector<Vector3d> axes;
  for (const auto& frame : frames) {
    for (int k = 0; k < 3; ++k) {
      const Vector3d axis = frame.col(k);
      if (std::none_of(axes.begin(), axes.end(), [&](const Vector3d& other) {
            return std::abs(axis.dot(other)) > kSameAxis;
          })) {
        axes.push_back(axis);
      }
    }
  }
  return axes;
}

/// Units: m^3.
double hullVolumeOf(const Points& points) {
  const TriangleMesh hull = convexHullOf(points);
  double sixfold = 0.0;
  for (const auto& t : hull.triangles) {
    sixfold += hull.vertices[t[0]].dot(hull.vertices[t[1]].cross(hull.vertices[t[2]]));
  }
  return sixfold / 6.0;
}

/// Of both shapes, where each sticks out over the mesh and the other.
double costOf(const CutChoice& choice, const RoughGoal& goal) {
  OvershootSum sum;
  const auto add = [&](const PlacedCore& core, const PlacedCore& other) {
    RoughGoal one = goal;
    one.others.push_back(other);
    sum.add(one.overshootOf(core));
  };
  add(choice.below.core, choice.above.core);
  add(choice.above.core, choice.below.core);
  return costOf(sum.total());
}

/// The cut below which `cut` slabs are; nothing if one side is empty.
std::optional<CutChoice> cutAt(const Slabs& slabs, int cut, const Matrix3d& frame,
                               const RoughGoal& goal) {
  const Points below = slabs.pointsOf(0, cut);
  const Points above = slabs.pointsOf(cut, Slabs::kCount);
  if (below.empty() || above.empty()) {
    return std::nullopt;
  }
  CutChoice choice;
  choice.plane = slabs.plane(cut);
  RoughGoal side = goal;
  side.plane = choice.plane;
  const auto fit = [&](const Points& points) {
    return fitRoughly(points, {frame, principalAxes(points), rotationWithAxis(choice.plane.normal)},
                      side);
  };
  choice.below = fit(below);
  choice.above = fit(above);
  choice.cost = costOf(choice, goal);
  return choice;
}

/// The best cut found along one axis.
class AxisSearch {
 public:
  AxisSearch(const Points& samples, const Vector3d& axis) : slabs_(samples, axis) {}

  bool hasFound() const { return best_cut_ > 0; }
  const CutChoice& best() const { return best_; }

  void searchAll(const Matrix3d& frame, const RoughGoal& goal) {
    for (int cut = kFirstStep; slabs_.canBeCut() && cut < Slabs::kCount; cut += kFirstStep) {
      consider(cut, frame, goal);
    }
  }

  void searchNearBest(const Matrix3d& frame, const RoughGoal& goal) {
    for (int step = kFirstStep / 2; step > 0; step /= 2) {
      const int middle = best_cut_;
      consider(middle - step, frame, goal);
      consider(middle + step, frame, goal);
    }
  }

  /// The cut that leaves the smallest hulls, wherever it is.
  void searchHulls(const Matrix3d& frame, const RoughGoal& goal) {
    double least = std::numeric_limits<double>::infinity();
    for (int cut = 1; slabs_.canBeCut() && cut < Slabs::kCount; ++cut) {
      const Points below = slabs_.pointsOf(0, cut);
      const Points above = slabs_.pointsOf(cut, Slabs::kCount);
      if (below.empty() || above.empty()) {
        continue;
      }
      const double volume = hullVolumeOf(below) + hullVolumeOf(above);
      if (volume < least) {
        least = volume;
        best_cut_ = cut;
      }
    }
    hull_volume_ = least;
    if (const auto choice = cutAt(slabs_, best_cut_, frame, goal)) {
      best_ = *choice;
    }
  }
  double hullVolume() const { return hull_volume_; }

  /// Moves both shapes to where they stick out least beside each other: only then it shows what a
  /// cut is worth.
  void polish(const RoughGoal& goal) {
    RoughGoal beside = goal;
    beside.others.push_back(best_.above.core);
    best_.below = polished(best_.below, slabs_.pointsOf(0, best_cut_), beside);
    beside.others.back() = best_.below.core;
    best_.above = polished(best_.above, slabs_.pointsOf(best_cut_, Slabs::kCount), beside);
    best_.cost = costOf(best_, goal);
  }

 private:
  void consider(int cut, const Matrix3d& frame, const RoughGoal& goal) {
    const auto choice = cutAt(slabs_, cut, frame, goal);
    if (choice && choice->cost < best_.cost) {
      best_ = *choice;
      best_cut_ = cut;
    }
  }

  Slabs slabs_;
  CutChoice best_;
  int best_cut_{0};                                              ///< 0: none
  double hull_volume_{std::numeric_limits<double>::infinity()};  ///< [m^3] of both sides, if sought
};

bool isBetter(const AxisSearch& a, const AxisSearch& b) { return a.best().cost < b.best().cost; }

std::optional<CutChoice> smallestHulls(const Points& samples, const std::vector<Vector3d>& axes,
                                       const Matrix3d& frame, const RoughGoal& goal) {
  std::optional<AxisSearch> best;
  for (const auto& axis : axes) {
    AxisSearch search(samples, axis);
    search.searchHulls(frame, goal);
    if (search.hasFound() && (!best || search.hullVolume() < best->hullVolume())) {
      best = std::move(search);
    }
  }
  if (!best) {
    return std::nullopt;
  }
  best->polish(goal);
  return best->best();
}

}  // namespace

double costOf(const Overshoot& overshoot) noexcept {
  return overshoot.fourth_power_mean + overshoot.max;
}

std::optional<CutChoice> chooseCut(const Points& samples, const PlacedCore& whole,
                                   const RoughGoal& goal, IdleCut idle) {
  const Matrix3d& frame = whole.rotation;
  const std::vector<Vector3d> axes = axesOf({frame, Matrix3d::Identity(), principalAxes(samples)});
  std::vector<AxisSearch> searches;
  for (const auto& axis : axes) {
    AxisSearch search(samples, axis);
    search.searchAll(frame, goal);
    if (search.hasFound()) {
      searches.push_back(std::move(search));
    }
  }
  if (searches.empty()) {
    return std::nullopt;
  }
  std::sort(searches.begin(), searches.end(), isBetter);
  searches.erase(searches.begin() + std::min(std::ptrdiff_t(searches.size()), kPolished),
                 searches.end());
  for (auto& search : searches) {
    search.searchNearBest(frame, goal);
    search.polish(goal);
  }
  CutChoice best = std::min_element(searches.begin(), searches.end(), isBetter)->best();
  const bool is_idle = !(best.cost < kWorthIt * costOf(goal.overshootOf(whole).total()));
  if (is_idle && idle == IdleCut::smallest_hulls) {
    best = smallestHulls(samples, axes, frame, goal).value_or(best);
  }
  best.is_idle = is_idle;
  return best;
}

}  // namespace collision_monitor
