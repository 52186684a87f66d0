// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/run_cycle.h"
#include "support/robots/geometry_setup.h"
#include "support/robots/hand_made_setup.h"

namespace collision_monitor::test {

inline SetupOptions optionsFor(RefineGeometry geometry) {
  SetupOptions options;
  options.limits = {0.0, 0.01, 0.002, 0.2};
  options.refine.geometry = geometry;
  options.default_limits.max_shapes = 1;
  return options;
}

/// A set-up whose links stand at the origin, and its cycles.
struct RefineScene {
  explicit RefineScene(CycleSetup made)
      : setup(std::move(made)),
        buffers(makeBuffers(setup, BroadPhaseKind::brute_force)),
        poses(knownPoses(setup)) {}
  explicit RefineScene(const std::vector<Geometry>& geometries,
                       const SetupOptions& options = optionsFor(RefineGeometry::mesh))
      : RefineScene(geometrySetup(geometries, options)) {}

  void run() { runCycle(setup, poses, buffers); }
  void moveTo(std::size_t link, double x) { poses.world_from_link[link].translation.x() = x; }
  const PairDistance& closest() const {
    return buffers.distances.pairs.at(buffers.events.closest_of_all);
  }
  Verdict verdict() const { return buffers.events.verdicts.at(0); }

  CycleSetup setup;
  CycleBuffers buffers;
  LinkPoses poses;
};

inline RefineScene hookedAngles(RefineGeometry geometry) {
  RefineScene scene({angleMesh(), angleMesh()}, optionsFor(geometry));
  scene.poses.world_from_link[1] = hookedPose();
  return scene;
}

}  // namespace collision_monitor::test
