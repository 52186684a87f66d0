// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <string>
#include <utility>

#include "pipeline/answers/carry_measurements.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/run_cycle.h"
#include "pipeline/world/add_world.h"
#include "support/robots/hand_made_setup.h"
#include "support/robots/world_objects.h"

namespace collision_monitor::world_laws {

constexpr std::size_t kLinks = 8;

/// A set-up, and what a watch keeps beside it.
struct Watched {
  explicit Watched(CycleSetup made)
      : setup(std::move(made)),
        buffers(makeBuffers(setup, BroadPhaseKind::automatic)),
        poses(test::knownPoses(setup)),
        tracker(makeVelocityTracker(setup.model)) {}

  /// Takes the poses of the robots' links; objects follow what carries them.
  void read(const LinkPoses& robots) {
    poses.stamp_ns = robots.stamp_ns;
    std::fill(poses.robot_stamp_ns.begin(), poses.robot_stamp_ns.end(), robots.stamp_ns);
    for (std::size_t i = 0; i < poses.status.size(); ++i) {
      const auto& joint = setup.model.links[i].parent_joint;
      if (i < kLinks) {
        poses.world_from_link[i] = robots.world_from_link[i];
        poses.status[i] = robots.status[i];
      } else if (joint) {
        const std::size_t parent = index(setup.model.joint(*joint).parent);
        poses.world_from_link[i] =
            poses.world_from_link[parent] * setup.model.joint(*joint).parent_from_joint;
        poses.status[i] = poses.status[parent];
      }
    }
    trackVelocities(setup.model, {}, tracker, poses);
    applyJointVelocities(setup.model, {}, poses);
  }

  void prepare(const LinkPoses& robots) {
    read(robots);
    prepareFirstCycle(setup, poses, buffers);
  }

  /// Without measurements of robots, which come from the former set-up. @pre the same robots
  void prepare(const LinkPoses& robots, const Watched& former) {
    new_element_pair_of = planMeasurements(former.setup, setup, planCarryOver(former.setup, setup));
    buffers.refine.skips_robots = !new_element_pair_of.empty();
    prepare(robots);
  }

  void takeOver(Watched& former) {
    const CarryPlan plan = planCarryOver(former.setup, setup);
    carryMotion(plan, setup, {former.poses, former.buffers.memory.last, former.tracker}, poses,
                buffers.memory, tracker);
    carryOver(plan, former.buffers.memory, buffers.memory);
    if (!new_element_pair_of.empty()) {
      carryMeasurements(new_element_pair_of, former.buffers, buffers);
    }
  }

  void cycle(const LinkPoses& robots) {
    read(robots);
    runCycle(setup, poses, buffers);
  }

  CycleSetup setup;
  CycleBuffers buffers;
  LinkPoses poses;
  VelocityTracker tracker;
  std::vector<ElementPairIndex> new_element_pair_of;
};

inline KnownPlaces places() {
  KnownPlaces places;
  for (std::size_t i = 0; i < kLinks; ++i) {
    places.links.push_back("link_" + std::to_string(i));
  }
  places.link_frames = places.links;
  places.world_frame = "map";
  return places;
}

inline CycleSetup withWorld(const CycleSetup& robots, const World& world) {
  return addWorld(robots, world, prepareObjects(world, RefineGeometry::mesh, {}), "map");
}

}  // namespace collision_monitor::world_laws
