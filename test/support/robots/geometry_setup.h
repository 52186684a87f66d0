// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/pipeline/setup.h"

namespace collision_monitor::test {

/// A set-up of free-floating links with one geometry each, fitted and made ready to be refined as
/// buildSetup does; every pair of links checked. Elements are called "collision_0".
CycleSetup geometrySetup(const std::vector<Geometry>& geometries, const SetupOptions& options);

/// The same for links that have collision elements and nothing else yet.
CycleSetup linkSetup(const std::vector<std::vector<CollisionElement>>& links,
                     const SetupOptions& options);

/// A closed angle of two bars 0.1 m thick, from the origin 0.3 m along x and 0.3 m along y, and
/// from -0.05 m to 0.05 m in z.
TriangleMesh angleMesh();

/// Hooks link 1 into link 0, both angles: their hulls overlap, and they are 0.02 m apart.
Pose hookedPose();

}  // namespace collision_monitor::test
