// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "narrow_phase/warm_start/distance_from_warm_start.h"

namespace collision_monitor {

/// distanceFromWarmStart for a cylinder and any core. Follows the corner, edge, face or rim of the
/// other that was nearest to where it is nearest now. A corner's closest point on a cylinder has a
/// closed form. Along an edge or a rim Newton's method finds the minimum. If a plane proves another
/// corner to be nearer, the edge to that corner is tried.
///
/// Error and limits: as distanceFromWarmStart. Two cylinders must be nearest at a rim of one, or at
/// both their sides. Source: Rockafellar, Wets, "Variational Analysis" (1998), chapter 13, for the
/// derivatives of the closest point of a convex set. Those of a cylinder follow from its
/// coordinates.
/// @pre at least one core is a cylinder.
std::optional<WarmStartDistance> cylinderFromWarmStart(const PlacedCore& a, const PlacedCore& b,
                                                       ConvexWarmStart& warm) noexcept;

/// True if a point of a cylinder, in its frame, is on one of its two rims.
bool isOnRim(const Eigen::Vector3d& point, const Eigen::Vector3d& half_extents) noexcept;

}  // namespace collision_monitor
