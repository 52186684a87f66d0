// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/search/core_descent.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "fitting/search/core_barrier.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;
using Step = CoreBarrier::Step;

constexpr double kWeightGrowth = 10.0;
constexpr int kMaxNewtonSteps = 12;
// Ends the steps of a weight: the possible gain is about half of it, over a weight of 300 or more.
constexpr double kLeastSlope = 1.0;
constexpr double kShortening = 0.7;
constexpr int kMaxShortenings = 40;

/// From the closest point of the core to the point, in the core's frame; 0 inside.
Vector3d beyondCore(const TurnedCore& core, const Vector3d& point) {
  const Vector3d in_core = core.rotation.transpose() * (point - core.center);
  return in_core - in_core.cwiseMax(-core.half_extents).cwiseMin(core.half_extents);
}

TurnedCore moved(const TurnedCore& core, const Step& step) {
  TurnedCore result = core;
  result.center += core.rotation * step.segment<3>(0);
  const Vector3d turn = step.segment<3>(3);
  if (turn.squaredNorm() > 0.0) {
    result.rotation = core.rotation * Eigen::AngleAxisd(turn.norm(), turn.normalized());
  }
  result.half_extents += step.segment<3>(6);
  result.radius += step[9];
  return result;
}

/// One damped Newton step. False when no further step is worthwhile.
bool improve(CoreBarrier& barrier, double weight, TurnedCore& core, double& value) {
  Step gradient;
  CoreBarrier::Hessian hessian;
  barrier.differentiate(weight, gradient, hessian);
  hessian.diagonal() *= 1.0 + 1e-9;
  const Step newton = -hessian.ldlt().solve(gradient);
  const double slope = newton.dot(gradient);
  if (!newton.allFinite() || !(slope < -kLeastSlope)) {
    return false;
  }
  double length = std::min(1.0, 0.5 / newton.cwiseAbs().maxCoeff());
  for (int i = 0; i < kMaxShortenings; ++i) {
    const TurnedCore next = moved(core, length * newton);
    if (barrier.place(next)) {
      const double next_value = barrier.value(weight);
      if (next_value < value + 0.1 * length * slope) {
        core = next;
        value = next_value;
        return true;
      }
    }
    length *= kShortening;
  }
  return false;
}

}  // namespace

double distanceToCore(const TurnedCore& core, const Vector3d& point) noexcept {
  return beyondCore(core, point).norm();
}

double enclosingRadius(const TurnedCore& core, const Points& points) noexcept {
  double squared = 0.0;
  for (const auto& point : points) {
    squared = std::max(squared, beyondCore(core, point).squaredNorm());
  }
  return std::sqrt(squared);
}

void descend(const Points& points, const DescentGoal& goal, TurnedCore& core) {
  CoreBarrier barrier(points, goal);
  double weight = goal.first_weight;
  while (weight <= goal.last_weight) {
    // Needed for each weight: the last step tried may have been rejected.
    if (!barrier.place(core)) {
      return;
    }
    double value = barrier.value(weight);
    for (int i = 0; i < kMaxNewtonSteps && improve(barrier, weight, core, value); ++i) {
    }
    weight *= kWeightGrowth;
  }
}

}  // namespace collision_monitor
