// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/pipeline/setup.h"

namespace collision_monitor::test {

/// A set-up of free-floating links with one geometry each, fitted and prepared for refinement as in
/// buildSetup. Every pair of links is checked. Elements are called "collision_0".
CycleSetup geometrySetup(const std::vector<Geometry>& geometries, const SetupOptions& options);

/// As above, for links that only have collision elements so far.
CycleSetup linkSetup(const std::vector<std::vector<CollisionElement>>& links,
                     const SetupOptions& options);

/// A closed angle of two bars 0.1 m thick: 0.3 m along x and 0.3 m along y from the origin, and
/// from -0.05 m to 0.05 m in z.
TriangleMesh angleMesh();

/// Hooks link 1 into link 0, both angles: their hulls overlap, and they are 0.02 m apart.
Pose hookedPose();

}  // namespace collision_monitor::test
