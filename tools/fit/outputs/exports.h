// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "fit_robot.h"
#include "fitting/sphere_trees/export_spheres.h"

namespace collision_monitor::fit_tool {

/// The shapes as rules that give them, for the user to edit and use. With each link's padding, and
/// marked as unproven where they are, so that the rules reproduce the same set-up.
std::string writeRules(const FittedRobot& robot);

/// Sphere hierarchies of every collision element of the fitted links, in the link's frame.
std::vector<LinkSpheres> buildSpheres(const FittedRobot& robot, std::size_t leaves);

/// One of their levels as an SRDF.
std::string writeSphereSrdf(const FittedRobot& robot, const std::vector<LinkSpheres>& spheres,
                            std::uint32_t level);

/// The URDF with padded shapes; see write_urdf.h.
std::string writeShapeUrdf(const FittedRobot& robot, const std::string& urdf_xml);

}  // namespace collision_monitor::fit_tool
