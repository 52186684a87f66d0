// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <string>

#include "collision_monitor/model/mesh_reading.h"
#include "collision_monitor/model/problems.h"
#include "ros_edge/parameters/resource_loader.h"

namespace collision_monitor {

/// Reads the parameter struct `files`: which files may be read, and with which limits. Faults are
/// added to `report`; faulty values keep their defaults.
void readFileParameters(const XmlRpc::XmlRpcValue& values, const std::string& where,
                        LoadRules& loading, MeshReading& meshes, SetupReport& report);

}  // namespace collision_monitor
