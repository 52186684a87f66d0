// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "narrow_phase/warm_start/distance_from_warm_start.h"

namespace collision_monitor {

/// The same as distanceFromWarmStart for a cylinder and any core: the corner, edge, face or rim of
/// the other that was nearest is followed to where it is nearest now. A corner's nearest point on a
/// cylinder has a closed form; along an edge or a rim Newton's method finds the least of it. Where
/// a plane proves another corner to be nearer, the edge to that corner is tried.
///
/// Error and limits: as distanceFromWarmStart. Of two cylinders one has to be met at its rim, or
/// both at their sides. Source: derivatives of the nearest point of a convex set by Rockafellar,
/// Wets, "Variational Analysis" (1998), chapter 13; for a cylinder they follow from its
/// coordinates.
/// @pre one core at least is a cylinder.
std::optional<WarmStartDistance> cylinderFromWarmStart(const PlacedCore& a, const PlacedCore& b,
                                                       ConvexWarmStart& warm) noexcept;

/// Whether a point of a cylinder, in its frame, is on one of its two rims.
bool isOnRim(const Eigen::Vector3d& point, const Eigen::Vector3d& half_extents) noexcept;

}  // namespace collision_monitor
