// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "pipeline/world/add_world.h"
#include "ros_edge/world/world_places.h"
#include "support/robots/world_objects.h"
#include "unit/ros_edge/edge_scene.h"

namespace collision_monitor::test {

/// The sliding robot with these objects.
inline std::shared_ptr<const MonitorSetup> slidingSetupWith(
    const std::vector<WorldObject>& objects, const SetupOptions& options = SetupOptions()) {
  auto made = std::make_shared<MonitorSetup>(*slidingSetup(options));
  made->robots = std::make_shared<CycleSetup>(made->setup);
  made->world = worldOf(objects, placesOf(made->robots->model, made->world_frame));
  made->prepared = prepareObjects(made->world, RefineGeometry::mesh, {});
  made->drawn = drawMeshes(made->world, {});
  made->setup = addWorld(*made->robots, made->world, made->prepared, made->world_frame);
  return made;
}

}  // namespace collision_monitor::test
