// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "fitting/search/core_descent.h"

namespace collision_monitor {

/// The function that a descent minimises: weight * log(volume) - sum of log(slack). A slack is
/// radius^2 - distance^2 of a point to the core, or a free half extent.
///
/// It is evaluated for all points at once, with one array per coordinate. Fits spend their time
/// here, and compilers turn arrays into vector instructions.
///
/// Variables: center and rotation vector in the core's frame, half extents, radius.
class CoreBarrier {
 public:
  static constexpr int kVariables = 10;
  using Step = Eigen::Matrix<double, kVariables, 1>;
  using Hessian = Eigen::Matrix<double, kVariables, kVariables>;

  CoreBarrier(const Points& points, const DescentGoal& goal);

  /// Sets the core to evaluate. If it returns false, a slack is <= 0 and no other call is allowed.
  bool place(const TurnedCore& core);

  double value(double weight) const;

  /// The gradient and a positive definite model of the Hessian (its lower half). The model leaves
  /// out the curvature of log(volume) and of rotations, which is negative. Variables that are fixed
  /// or have no effect get no gradient.
  void differentiate(double weight, Step& gradient, Hessian& hessian);

 private:
  using Column = Eigen::Array<double, Eigen::Dynamic, 1>;
  using Coordinates = Eigen::Array<double, Eigen::Dynamic, 3>;
  using Rows = Eigen::Array<double, Eigen::Dynamic, kVariables>;

  /// Adds the curvature of the distances along one axis of the core.
  void addCurvature(int axis, Hessian& hessian);
  /// Adds the contribution of the gradients of the slacks.
  void addSlopes(Step& gradient, Hessian& hessian);
  void fixTheOthers(Step& gradient, Hessian& hessian) const;

  DescentGoal goal_;
  std::vector<int> free_variables_;
  TurnedCore core_;
  Coordinates points_;
  Coordinates in_core_;  ///< the points in the core's frame
  Coordinates beyond_;   ///< from the closest point of the core, signed; 0 inside
  Column slack_;
  Column weighted_;  ///< buffer for products
  Rows slack_gradient_;
};

}  // namespace collision_monitor
