// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/narrowphase/collision_object.h>

#include <memory>
#include <optional>

#include "collision_monitor/geometry/pose.h"
#include "collision_monitor/geometry/shapes.h"
#include "collision_monitor/narrow_phase/convex_distance.h"

/// The flexible collision library as a peer to compare with. Nothing but tests, benchmarks and
/// the comparison tool may use this.
namespace collision_monitor::test {

using FclObject = fcl::CollisionObject<double>;
using FclGeometry = std::shared_ptr<fcl::CollisionGeometryd>;

/// @return nullptr for what FCL has no shape for: a rounded box with a radius, a half space.
FclGeometry toFclGeometry(const ConvexGeometry& geometry);

/// @return nothing for a rounded box with a radius: FCL has no such shape.
std::optional<FclObject> toFcl(const Shape& shape, const Pose& world_from_shape);

/// Distance by FCL's default solver (libccd); 0 or less when it sees an overlap, in which case the
/// value says nothing about the depth.
/// @return nothing when FCL throws.
std::optional<double> fclDistance(const FclObject& a, const FclObject& b);

/// Distance, or minus the depth, by the only query of FCL's that tells both: libccd's GJK and EPA.
/// @return nothing when FCL throws.
std::optional<double> fclSignedDistance(const FclObject& a, const FclObject& b);

/// @return nothing when FCL throws.
std::optional<bool> fclOverlap(const FclObject& a, const FclObject& b);

/// Largest penetration depth among the contacts FCL reports, >= 0.
/// @return nothing when FCL throws or reports no contact.
std::optional<double> fclDepth(const FclObject& a, const FclObject& b);

}  // namespace collision_monitor::test
