// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <string>

#include "collision_monitor/model/mesh_reading.h"
#include "collision_monitor/model/problems.h"
#include "ros_edge/parameters/resource_loader.h"

namespace collision_monitor {

/// Reads the struct `files` of the parameters: which files may be read, and what they may take.
/// Faults are added to `report`; what is at fault keeps its default.
void readFileParameters(const XmlRpc::XmlRpcValue& values, const std::string& where,
                        LoadRules& loading, MeshReading& meshes, SetupReport& report);

}  // namespace collision_monitor
