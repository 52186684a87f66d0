// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <collision_monitor/SceneChange.h>
#include <collision_monitor/SceneObjects.h>

#include <vector>

#include "collision_monitor/model/urdf_reader.h"
#include "collision_monitor/model/world.h"
#include "ros_edge/parameters/monitor_setup.h"

/// Objects in messages.
namespace collision_monitor {

/// Reads the files that messages name.
struct ObjectFiles {
  const ResourceLoader& load_resource;
  const MeshReading& meshes;
};

/// Converts all changes. Adds each fault that applyChanges cannot see: a primitive without its
/// dimensions, a quaternion that is not of unit length, a file that cannot be read.
/// @throws Interrupted
std::vector<ObjectChange> fromMessages(const std::vector<SceneChange>& messages,
                                       const ObjectFiles& files, SetupReport& report);

/// Meshes of files are listed with their triangles.
void toMessage(const WorldObject& object, SceneObject& message);
SceneObjects listOf(const MonitorSetup& setup);

}  // namespace collision_monitor
