// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "collision_monitor/fitting/posed_shape.h"

namespace collision_monitor {

/// A rounded box while it is being fitted. A zero half extent that is not free stays zero, so that
/// spheres and capsules are fitted as what they are: rounded boxes with fewer freedoms.
struct TurnedCore {
  Eigen::Matrix3d rotation{Eigen::Matrix3d::Identity()};
  Eigen::Vector3d center{Eigen::Vector3d::Zero()};
  Eigen::Vector3d half_extents{Eigen::Vector3d::Zero()};
  double radius{0.0};
};

/// Which half extents a fit may change. The rotation is free about every axis that makes a
/// difference.
using FreeExtents = Eigen::Matrix<bool, 3, 1>;

/// The distance of a point to the core, 0 inside.
double distanceToCore(const TurnedCore& core, const Eigen::Vector3d& point) noexcept;

/// The distance of the farthest point from the core: the radius that encloses all.
double enclosingRadius(const TurnedCore& core, const Points& points) noexcept;

/// What a descent may change and what it minimises.
struct DescentGoal {
  FreeExtents free_extents{true, true, true};
  /// The volume that counts is that of the shape with its radius larger by this. Growth makes
  /// corners count for more: the least shape sticks out less far, though it may be larger.
  double growth{0.0};
  /// Of the volume against the barrier, at first and at last. The volume comes out too large by a
  /// fraction of about ten over the last one.
  double first_weight{300.0};
  double last_weight{3e5};
};

/// Moves a core in which all points lie strictly inside, and whose free extents are positive,
/// towards a local minimum of the volume; any other core stays where it is.
///
/// An interior-point method: it minimises weight * log(volume) - sum of log(slack), see
/// core_barrier.h, by damped Newton steps for growing weights. All points stay strictly inside on
/// the way, so the result encloses without a repair; its radius leaves a little room.
///
/// Units: any; sizes near 1 are best conditioned.
/// Source: Boyd, Vandenberghe, "Convex Optimization" (2004), section 11.3 (barrier method) and
/// 11.6 (second-order cones: for a fixed rotation the feasible set is convex).
void descend(const Points& points, const DescentGoal& goal, TurnedCore& core);

}  // namespace collision_monitor
