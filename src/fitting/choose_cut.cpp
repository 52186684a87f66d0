// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/choose_cut.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "fitting/point_cloud.h"

namespace collision_monitor {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int kSlabs = 80;               // between the places where a part may be cut along an axis
constexpr int kFirstStep = 16;           // of these, between the places that are looked at first
constexpr int kDirections = 48;          // whose farthest points stand for a part
constexpr std::ptrdiff_t kPolished = 4;  // axes whose best cuts are compared closely
constexpr double kSameAxis = 0.97;

/// The farthest points of a slab in all directions.
struct Extremes {
  std::array<double, kDirections> reach;
  std::array<std::uint32_t, kDirections> point;

  Extremes() { reach.fill(-std::numeric_limits<double>::infinity()); }
  bool isEmpty() const { return !std::isfinite(reach[0]); }
  void add(const Extremes& other) {
    for (std::size_t i = 0; i < kDirections; ++i) {
      if (other.reach[i] > reach[i]) {
        reach[i] = other.reach[i];
        point[i] = other.point[i];
      }
    }
  }
};

const Points& directions() {
  static const Points spread = spreadDirections(kDirections);
  return spread;
}

Points pointsOf(const Extremes& extremes, const Points& samples) {
  auto chosen = extremes.point;
  std::sort(chosen.begin(), chosen.end());
  Points points;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    if (i == 0 || chosen[i] != chosen[i - 1]) {
      points.push_back(samples[chosen[i]]);
    }
  }
  return points;
}

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

/// A part in slabs across an axis.
class Slabs {
 public:
  Slabs(const Points& samples, const Vector3d& axis) : samples_(&samples), axis_(axis) {
    low_ = std::numeric_limits<double>::infinity();
    double high = -low_;
    for (const auto& sample : samples) {
      low_ = std::min(low_, axis.dot(sample));
      high = std::max(high, axis.dot(sample));
    }
    thickness_ = (high - low_) / kSlabs;
    if (!(thickness_ > 0.0)) {
      return;
    }
    for (std::uint32_t i = 0; i < samples.size(); ++i) {
      const double height = (axis.dot(samples[i]) - low_) / thickness_;
      const int slab = std::clamp(static_cast<int>(height), 0, kSlabs - 1);
      add(i, slabs_[static_cast<std::size_t>(slab)]);
    }
  }

  bool canBeCut() const { return thickness_ > 0.0; }
  CutPlane plane(int below) const { return {axis_, low_ + below * thickness_}; }

  /// Points that stand for the slabs [first, last); none if these are empty.
  Points pointsOf(int first, int last) const {
    Extremes extremes;
    for (int i = first; i < last; ++i) {
      extremes.add(slabs_[static_cast<std::size_t>(i)]);
    }
    return extremes.isEmpty() ? Points{} : collision_monitor::pointsOf(extremes, *samples_);
  }

 private:
  void add(std::uint32_t i, Extremes& extremes) const {
    for (std::size_t d = 0; d < kDirections; ++d) {
      const double reach = directions()[d].dot((*samples_)[i]);
      if (reach > extremes.reach[d]) {
        extremes.reach[d] = reach;
        extremes.point[d] = i;
      }
    }
  }

  const Points* samples_;
  Vector3d axis_;
  double low_{0.0};
  double thickness_{0.0};
  std::array<Extremes, kSlabs> slabs_;
};

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
  const Overshoot overshoot = sum.total();
  return overshoot.fourth_power_mean + overshoot.max;
}

/// The cut below which `cut` slabs are; nothing if one side is empty.
std::optional<CutChoice> cutAt(const Slabs& slabs, int cut, const Matrix3d& frame,
                               const RoughGoal& goal) {
  const Points below = slabs.pointsOf(0, cut);
  const Points above = slabs.pointsOf(cut, kSlabs);
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
    for (int cut = kFirstStep; slabs_.canBeCut() && cut < kSlabs; cut += kFirstStep) {
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

  /// Moves both shapes to where they stick out least beside each other: only then it shows what a
  /// cut is worth.
  void polish(const RoughGoal& goal) {
    RoughGoal beside = goal;
    beside.others.push_back(best_.above.core);
    best_.below = polished(best_.below, slabs_.pointsOf(0, best_cut_), beside);
    beside.others.back() = best_.below.core;
    best_.above = polished(best_.above, slabs_.pointsOf(best_cut_, kSlabs), beside);
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

std::optional<CutChoice> chooseCut(const Points& samples, const Matrix3d& frame,
                                   const RoughGoal& goal) {
  std::vector<AxisSearch> searches;
  for (const auto& axis : axesOf({frame, Matrix3d::Identity(), principalAxes(samples)})) {
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
  return std::min_element(searches.begin(), searches.end(), isBetter)->best();
}

}  // namespace collision_monitor
