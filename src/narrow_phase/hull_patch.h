// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/hull.h"
#include "collision_monitor/narrow_phase/manifold.h"

namespace collision_monitor {

/// The feature of a hull that is extreme in `direction` (unit): a face or an edge that is flat to
/// kFlatSine, or a vertex. World frame.
///
/// Limits: of a face with more corners than a patch has, some are left out, evenly. Looks at every
/// face, and at every edge for each corner of the face: for messages, not for inner loops.
ContactPatch extremePatch(const ConvexHull& hull, const Pose& world_from_hull,
                          const Eigen::Vector3d& direction) noexcept;

}  // namespace collision_monitor
