// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "collision_monitor/fitting/posed_shape.h"

namespace collision_monitor {

/// A rounded box during a fit. A zero half extent that is not free stays zero. So spheres and
/// capsules are fitted as rounded boxes with fewer degrees of freedom.
struct TurnedCore {
  Eigen::Matrix3d rotation{Eigen::Matrix3d::Identity()};
  Eigen::Vector3d center{Eigen::Vector3d::Zero()};
  Eigen::Vector3d half_extents{Eigen::Vector3d::Zero()};
  double radius{0.0};
};

/// Which half extents a fit may change. The rotation is free about every axis that has an effect.
using FreeExtents = Eigen::Matrix<bool, 3, 1>;

/// The distance of a point to the core, 0 inside.
double distanceToCore(const TurnedCore& core, const Eigen::Vector3d& point) noexcept;

/// The distance of the farthest point from the core: the radius that encloses all points.
double enclosingRadius(const TurnedCore& core, const Points& points) noexcept;

/// What a descent may change and what it minimises.
struct DescentGoal {
  FreeExtents free_extents{true, true, true};
  /// The descent minimises the volume of the shape with its radius increased by this. Growth gives
  /// corners more weight: the result sticks out less far, though it may be larger.
  double growth{0.0};
  /// First and last weight of the volume relative to the barrier. The volume is too large by about
  /// ten over the last weight, as a fraction.
  double first_weight{300.0};
  double last_weight{3e5};
};

/// Moves a core to a local minimum of the volume. All points must lie strictly inside and free
/// extents must be positive; any other core stays unchanged.
///
/// An interior-point method: it minimises weight * log(volume) - sum of log(slack), see
/// core_barrier.h, by damped Newton steps for growing weights. All points stay strictly inside, so
/// the result encloses them without a repair. Its radius leaves a little room.
///
/// Units: any; sizes near 1 are best conditioned.
/// Source: Boyd, Vandenberghe, "Convex Optimization" (2004), section 11.3 (barrier method) and
/// 11.6 (second-order cones: for a fixed rotation the feasible set is convex).
void descend(const Points& points, const DescentGoal& goal, TurnedCore& core);

}  // namespace collision_monitor
