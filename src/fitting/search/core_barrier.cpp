// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/search/core_barrier.h"

#include <algorithm>
#include <cmath>

#include "collision_monitor/geometry/shapes.h"
#include "geometry/constants.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

constexpr int kCenter = 0;
constexpr int kRotation = 3;
constexpr int kExtents = 6;
constexpr int kRadius = 9;

double grownVolume(const TurnedCore& core, double growth) {
  return volumeOf(RoundedBox{core.half_extents, core.radius + growth});
}

/// d volume / d (half extents, radius).
Eigen::Vector4d volumeGradient(const TurnedCore& core, double growth) {
  const Vector3d& h = core.half_extents;
  const double r = core.radius + growth;
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

/// The sum of many logarithms, with few calls of std::log.
template <class Column>
double logSum(const Column& values) {
  double sum = 0.0;
  double product = 1.0;
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    product *= values[i];
    if (product < 1e-200 || product > 1e200) {
      sum += std::log(product);
      product = 1.0;
    }
  }
  return sum + std::log(product);
}

}  // namespace

CoreBarrier::CoreBarrier(const Points& points, const DescentGoal& goal) : goal_(goal) {
  const auto count = static_cast<Eigen::Index>(points.size());
  points_.resize(count, 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    points_.row(i) = points[static_cast<std::size_t>(i)].transpose();
  }
  in_core_.resize(count, 3);
  beyond_.resize(count, 3);
  slack_.resize(count);
  weighted_.resize(count);
  slack_gradient_.resize(count, kVariables);
  const auto release = [this](int variable, bool is_free) {
    if (is_free) {
      free_variables_.push_back(variable);
    }
  };
  for (int k = 0; k < 3; ++k) {
    release(kCenter + k, true);
  }
  for (int k = 0; k < 3; ++k) {
    // A rotation about axis k has no effect if the core has no extent across it.
    release(kRotation + k, goal.free_extents[(k + 1) % 3] || goal.free_extents[(k + 2) % 3]);
  }
  for (int k = 0; k < 3; ++k) {
    release(kExtents + k, goal.free_extents[k]);
  }
  release(kRadius, true);
}

bool CoreBarrier::place(const TurnedCore& core) {
  core_ = core;
  for (int k = 0; k < 3; ++k) {
    if (goal_.free_extents[k] && !(core.half_extents[k] > 0.0)) {
      return false;
    }
  }
  if (!(core.radius > 0.0)) {
    return false;
  }
  slack_.setConstant(core.radius * core.radius);
  for (int k = 0; k < 3; ++k) {
    const Vector3d axis = core.rotation.col(k);
    const double middle = axis.dot(core.center);
    const double reach = core.half_extents[k];
    in_core_.col(k) =
        points_.col(0) * axis.x() + points_.col(1) * axis.y() + points_.col(2) * axis.z() - middle;
    beyond_.col(k) = in_core_.col(k) - in_core_.col(k).max(-reach).min(reach);
    slack_ -= beyond_.col(k).square();
  }
  return slack_.minCoeff() > 0.0;
}

double CoreBarrier::value(double weight) const {
  double value = weight * std::log(grownVolume(core_, goal_.growth)) - logSum(slack_);
  for (int k = 0; k < 3; ++k) {
    value -= goal_.free_extents[k] ? std::log(core_.half_extents[k]) : 0.0;
  }
  return value;
}

void CoreBarrier::addCurvature(int axis, Hessian& hessian) {
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  // The gradient of |beyond| along the axis: sign * (-1, axis x point), and -1 for the extent.
  const int variables[] = {kCenter + axis, kRotation + u, kRotation + v, kExtents + axis};
  auto rows = slack_gradient_.leftCols<4>();
  rows.col(0) = -beyond_.col(axis).sign();
  rows.col(1) = rows.col(0) * in_core_.col(v);
  rows.col(2) = -rows.col(0) * in_core_.col(u);
  rows.col(3) = -rows.col(0).abs();
  for (int i = 0; i < 4; ++i) {
    weighted_ = 2.0 * rows.col(i) / slack_;
    for (int j = 0; j <= i; ++j) {
      const auto [lower, upper] = std::minmax({variables[i], variables[j]});
      hessian(upper, lower) += (weighted_ * rows.col(j)).sum();
    }
  }
}

void CoreBarrier::addSlopes(Step& gradient, Hessian& hessian) {
  for (int k = 0; k < 3; ++k) {
    const int u = (k + 1) % 3;
    const int v = (k + 2) % 3;
    slack_gradient_.col(kCenter + k) = 2.0 * beyond_.col(k);
    slack_gradient_.col(kRotation + k) =
        2.0 * (in_core_.col(u) * beyond_.col(v) - in_core_.col(v) * beyond_.col(u));
    slack_gradient_.col(kExtents + k) = 2.0 * beyond_.col(k).abs();
  }
  slack_gradient_.col(kRadius).setConstant(2.0 * core_.radius);
  hessian(kRadius, kRadius) -= 2.0 * slack_.inverse().sum();
  for (std::size_t i = 0; i < free_variables_.size(); ++i) {
    const int a = free_variables_[i];
    weighted_ = slack_gradient_.col(a) / slack_;
    gradient[a] -= weighted_.sum();
    weighted_ /= slack_;
    for (std::size_t j = 0; j <= i; ++j) {
      const int b = free_variables_[j];
      hessian(a, b) += (weighted_ * slack_gradient_.col(b)).sum();
    }
  }
}

void CoreBarrier::fixTheOthers(Step& gradient, Hessian& hessian) const {
  auto next = free_variables_.begin();
  for (int i = 0; i < kVariables; ++i) {
    if (next != free_variables_.end() && *next == i) {
      ++next;
    } else {
      gradient[i] = 0.0;
      hessian.row(i).setZero();
      hessian.col(i).setZero();
      hessian(i, i) = 1.0;
    }
  }
}

void CoreBarrier::differentiate(double weight, Step& gradient, Hessian& hessian) {
  gradient.setZero();
  hessian.setZero();
  gradient.tail<4>() =
      weight / grownVolume(core_, goal_.growth) * volumeGradient(core_, goal_.growth);
  for (int k = 0; k < 3; ++k) {
    if (goal_.free_extents[k]) {
      const double inverse = 1.0 / core_.half_extents[k];
      gradient[kExtents + k] -= inverse;
      hessian(kExtents + k, kExtents + k) += inverse * inverse;
    }
    addCurvature(k, hessian);
  }
  addSlopes(gradient, hessian);
  fixTheOthers(gradient, hessian);
}

}  // namespace collision_monitor
