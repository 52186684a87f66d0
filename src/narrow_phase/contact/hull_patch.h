// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/hull.h"
#include "collision_monitor/geometry/shapes.h"
#include "narrow_phase/contact/manifold.h"

namespace collision_monitor {

/// Finds the feature of a hull that is extreme in `direction` (unit): a face or an edge that is
/// flat up to the sine `flat_sine`, or a vertex. Frames: world.
///
/// Limits: of a face with too many corners for a patch, some are left out, evenly. Looks at every
/// face.
ContactPatch extremePatch(const ConvexHull& hull, const Pose& world_from_hull,
                          const Eigen::Vector3d& direction, double flat_sine = kFlatSine) noexcept;

/// The same, but looks only at the faces and edges of a vertex that is known to be extreme.
ContactPatch patchAt(std::uint32_t vertex, const ConvexHull& hull, const Pose& world_from_hull,
                     const Eigen::Vector3d& direction, double flat_sine) noexcept;

/// The same for a cylinder: a cap, a line of its side, or a point of a rim.
///
/// Limits: a cap has as many evenly spread rim points as a patch has corners. Between them the rim
/// sticks out by up to 2 % of the radius.
ContactPatch extremePatch(const Cylinder& cylinder, const Pose& world_from_cylinder,
                          const Eigen::Vector3d& direction, double flat_sine = kFlatSine) noexcept;

}  // namespace collision_monitor
