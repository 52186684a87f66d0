// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/model/problems.h"
#include "collision_monitor/model/robot_model.h"
#include "fitting/sphere_trees/export_spheres.h"

namespace collision_monitor::fit_tool {

/// A warning for each pair of links that are not adjacent and whose finest spheres overlap in the
/// default pose (see defaultPositions). Checks by spheres report a contact there, even if the links
/// do not touch.
std::vector<Problem> sphereOverlaps(const RobotModel& model,
                                    const std::vector<LinkSpheres>& spheres);

}  // namespace collision_monitor::fit_tool
