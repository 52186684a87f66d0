// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/hull.h"
#include "collision_monitor/geometry/shapes.h"
#include "narrow_phase/contact/manifold.h"

namespace collision_monitor {

/// The feature of a hull that is extreme in `direction` (unit): a face or an edge that is flat to
/// `flat_sine`, or a vertex. World frame.
///
/// Limits: of a face with more corners than a patch has, some are left out, evenly. Looks at every
/// face.
ContactPatch extremePatch(const ConvexHull& hull, const Pose& world_from_hull,
                          const Eigen::Vector3d& direction, double flat_sine = kFlatSine) noexcept;

/// The same of the faces and edges at a vertex that is known to be extreme, and no others.
ContactPatch patchAt(std::uint32_t vertex, const ConvexHull& hull, const Pose& world_from_hull,
                     const Eigen::Vector3d& direction, double flat_sine) noexcept;

/// The same of a cylinder: a cap, a line of its side, or a point of a rim.
///
/// Limits: of a cap there are as many points of the rim as a patch has corners, evenly spread; what
/// lies between two of them and the rim is 2 % of the radius high.
ContactPatch extremePatch(const Cylinder& cylinder, const Pose& world_from_cylinder,
                          const Eigen::Vector3d& direction, double flat_sine = kFlatSine) noexcept;

}  // namespace collision_monitor
