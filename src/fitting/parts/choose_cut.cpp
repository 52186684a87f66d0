// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/parts/choose_cut.h"

#include <algorithm>
#include <cmath>

#include "fitting/parts/slabs.h"
#include "fitting/search/point_cloud.h"

namespace collision_monitor {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int kFirstStep = 16;           // between the places that are tried first
constexpr std::ptrdiff_t kPolished = 4;  // axes whose best cuts are compared closely
constexpr double kWorthIt = 0.9;         // of the cost before the cut

/// The cost of both shapes: where each sticks out over the mesh and the other.
double costOf(const CutChoice& choice, const RoughGoal& goal) {
  OvershootSum sum;
  const auto add = [&](const TurnedCore& core, const TurnedCore& other) {
    RoughGoal one = goal;
    one.others.push_back(other);
    sum.add(one.overshootOf(core));
  };
  add(choice.below.core, choice.above.core);
  add(choice.above.core, choice.below.core);
  return costOf(sum.total());
}

/// The cut above `cut` slabs; none if one side is empty.
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

  /// Moves both shapes to where they stick out least, given each other: only this shows the worth
  /// of a cut.
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
  int best_cut_{0};  ///< 0: none
};

bool isBetter(const AxisSearch& a, const AxisSearch& b) { return a.best().cost < b.best().cost; }

}  // namespace

double costOf(const Overshoot& overshoot) noexcept {
  return overshoot.fourth_power_mean + overshoot.max;
}

std::optional<CutChoice> chooseCut(const Points& samples, const TurnedCore& whole,
                                   const RoughGoal& goal) {
  const Matrix3d& frame = whole.rotation;
  const std::vector<Vector3d> axes =
      distinctAxes({frame, Matrix3d::Identity(), principalAxes(samples)});
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
  best.is_idle = !(best.cost < kWorthIt * costOf(goal.overshootOf(whole).total()));
  return best;
}

}  // namespace collision_monitor
