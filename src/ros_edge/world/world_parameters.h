// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <string>
#include <vector>

#include "collision_monitor/model/world.h"
#include "ros_edge/parameters/parameters.h"

namespace collision_monitor {

/// A parameter as YAML that reads back as the same value.
std::string yamlOf(const XmlRpc::XmlRpcValue& value);

/// The objects of the parameters `world` and `world_file`, in this order. Faults of texts and files
/// are added to `report`.
/// @throws Interrupted
std::vector<WorldObject> loadObjects(const Parameters& parameters,
                                     const ResourceLoader& load_resource, SetupReport& report);

/// Refuses objects without a frame while nobody knows which frame they mean: without the parameter
/// world_frame that is the root of the first robot, not that of the robot which is there first.
/// @param world_frame the parameter
void checkFrames(const std::vector<WorldObject>& objects, const ListedRobot& first,
                 const std::string& world_frame, SetupReport& report);

}  // namespace collision_monitor
