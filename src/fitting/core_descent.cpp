// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/core_descent.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "collision_monitor/geometry/shapes.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

// Order of the variables: centre and rotation in the core's frame, half extents, radius.
constexpr int kCentre = 0;
constexpr int kRotation = 3;
constexpr int kExtents = 6;
constexpr int kRadius = 9;
constexpr int kVariables = 10;
using Step = Eigen::Matrix<double, kVariables, 1>;
using Hessian = Eigen::Matrix<double, kVariables, kVariables>;

constexpr double kLastWeight = 1e6;
constexpr double kWeightGrowth = 10.0;
constexpr int kMaxNewtonSteps = 12;
constexpr int kMaxHalvings = 20;

double volumeOf(const PlacedCore& core, double growth) {
  return collision_monitor::volumeOf(RoundedBox{core.half_extents, core.radius + growth});
}

/// Where a point lies relative to the core.
struct Offset {
  Vector3d in_core;  ///< the point in the core's frame
  Vector3d beyond;   ///< from the nearest point of the core, signed; 0 inside
};

Offset offsetOf(const PlacedCore& core, const Vector3d& point) {
  Offset offset;
  offset.in_core = core.rotation.transpose() * (point - core.centre);
  offset.beyond =
      offset.in_core - offset.in_core.cwiseMax(-core.half_extents).cwiseMin(core.half_extents);
  return offset;
}

double barrierValue(const Points& points, const DescentGoal& goal, double weight,
                    const PlacedCore& core) {
  double value = weight * std::log(volumeOf(core, goal.growth));
  for (int k = 0; k < 3; ++k) {
    value -= goal.free_extents[k] ? std::log(core.half_extents[k]) : 0.0;
  }
  double product = 1.0;  // one logarithm for many slacks
  for (const auto& point : points) {
    const double slack = core.radius * core.radius - offsetOf(core, point).beyond.squaredNorm();
    if (!(slack > 0.0)) {
      return std::numeric_limits<double>::infinity();
    }
    product *= slack;
    if (product < 1e-200 || product > 1e200) {
      value -= std::log(product);
      product = 1.0;
    }
  }
  return value - std::log(product);
}

/// d volume / d (half extents, radius).
Eigen::Vector4d volumeGradient(const PlacedCore& core, double growth) {
  const Vector3d& h = core.half_extents;
  const double r = core.radius + growth;
  constexpr double kPi = 3.14159265358979323846;
  const double sum = h.sum();
  const double pairs = h.x() * h.y() + h.y() * h.z() + h.z() * h.x();
  Eigen::Vector4d gradient;
  for (int k = 0; k < 3; ++k) {
    const double u = h[(k + 1) % 3];
    const double v = h[(k + 2) % 3];
    gradient[k] = 8.0 * (u * v + r * (u + v)) + 2.0 * kPi * r * r;
  }
  gradient[3] = 8.0 * pairs + 4.0 * kPi * r * sum + 4.0 * kPi * r * r;
  return gradient;
}

/// Gradient and a positive semidefinite model of the Hessian of the barrier function.
void differentiate(const Points& points, const DescentGoal& goal, double weight,
                   const PlacedCore& core, Step& gradient, Hessian& hessian) {
  gradient.setZero();
  hessian.setZero();
  gradient.tail<4>() = weight / volumeOf(core, goal.growth) * volumeGradient(core, goal.growth);
  for (int k = 0; k < 3; ++k) {
    if (goal.free_extents[k]) {
      gradient[kExtents + k] -= 1.0 / core.half_extents[k];
      hessian(kExtents + k, kExtents + k) += 1.0 / (core.half_extents[k] * core.half_extents[k]);
    }
  }
  for (const auto& point : points) {
    const Offset offset = offsetOf(core, point);
    const double slack = core.radius * core.radius - offset.beyond.squaredNorm();
    Step slack_gradient;
    slack_gradient.segment<3>(kCentre) = 2.0 * offset.beyond;
    slack_gradient.segment<3>(kRotation) = 2.0 * offset.in_core.cross(offset.beyond);
    slack_gradient.segment<3>(kExtents) = 2.0 * offset.beyond.cwiseAbs();
    slack_gradient[kRadius] = 2.0 * core.radius;
    gradient -= slack_gradient / slack;
    hessian.noalias() += slack_gradient * (slack_gradient / (slack * slack)).transpose();
    hessian(kRadius, kRadius) -= 2.0 / slack;
    for (int k = 0; k < 3; ++k) {
      if (offset.beyond[k] != 0.0) {
        Step row = Step::Zero();  // d |beyond_k|
        const double sign = offset.beyond[k] > 0.0 ? 1.0 : -1.0;
        row[kCentre + k] = -sign;
        row.segment<3>(kRotation) = sign * Vector3d::Unit(k).cross(offset.in_core);
        row[kExtents + k] = -1.0;
        hessian.noalias() += row * (2.0 / slack * row).transpose();
      }
    }
  }
}

PlacedCore moved(const PlacedCore& core, const Step& step) {
  PlacedCore result = core;
  result.centre += core.rotation * step.segment<3>(kCentre);
  const Vector3d turn = step.segment<3>(kRotation);
  if (turn.squaredNorm() > 0.0) {
    result.rotation = core.rotation * Eigen::AngleAxisd(turn.norm(), turn.normalized());
  }
  result.half_extents += step.segment<3>(kExtents);
  result.radius += step[kRadius];
  return result;
}

bool isLegal(const PlacedCore& core, const DescentGoal& goal) {
  for (int k = 0; k < 3; ++k) {
    if (goal.free_extents[k] && !(core.half_extents[k] > 0.0)) {
      return false;
    }
  }
  return core.radius > 0.0;
}

/// Leaves the variables that are fixed, or that change nothing, where they are.
void fixVariables(const DescentGoal& goal, Step& gradient, Hessian& hessian) {
  const auto fix = [&](int i) {
    gradient[i] = 0.0;
    hessian.row(i).setZero();
    hessian.col(i).setZero();
    hessian(i, i) = 1.0;
  };
  for (int k = 0; k < 3; ++k) {
    if (!goal.free_extents[k]) {
      fix(kExtents + k);
    }
    // A turn about axis k changes nothing when the core has no extent across it.
    if (!goal.free_extents[(k + 1) % 3] && !goal.free_extents[(k + 2) % 3]) {
      fix(kRotation + k);
    }
  }
}

/// One damped Newton step; false when no step lowers the function any more.
bool improve(const Points& points, const DescentGoal& goal, double weight, PlacedCore& core,
             double& value) {
  Step gradient;
  Hessian hessian;
  differentiate(points, goal, weight, core, gradient, hessian);
  fixVariables(goal, gradient, hessian);
  hessian.diagonal() *= 1.0 + 1e-9;
  const Step newton = -hessian.ldlt().solve(gradient);
  const double slope = newton.dot(gradient);
  if (!newton.allFinite() || !(slope < -1e-3)) {
    return false;
  }
  double length = 2.0 * std::min(1.0, 0.5 / newton.cwiseAbs().maxCoeff());
  for (int halvings = 0; halvings < kMaxHalvings; ++halvings) {
    length *= 0.5;
    const PlacedCore next = moved(core, length * newton);
    const double next_value = isLegal(next, goal) ? barrierValue(points, goal, weight, next)
                                                  : std::numeric_limits<double>::infinity();
    if (next_value < value + 0.1 * length * slope) {
      core = next;
      value = next_value;
      return true;
    }
  }
  return false;
}

}  // namespace

double distanceToCore(const PlacedCore& core, const Vector3d& point) noexcept {
  return offsetOf(core, point).beyond.norm();
}

double enclosingRadius(const PlacedCore& core, const Points& points) noexcept {
  double squared = 0.0;
  for (const auto& point : points) {
    squared = std::max(squared, offsetOf(core, point).beyond.squaredNorm());
  }
  return std::sqrt(squared);
}

void descend(const Points& points, const DescentGoal& goal, PlacedCore& core) {
  double weight = goal.first_weight;
  while (weight <= kLastWeight) {
    double value = barrierValue(points, goal, weight, core);
    for (int i = 0; i < kMaxNewtonSteps && improve(points, goal, weight, core, value); ++i) {
    }
    weight *= kWeightGrowth;
  }
  core.radius = enclosingRadius(core, points);
}

}  // namespace collision_monitor
