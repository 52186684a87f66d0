// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/geometry/bounds.h"
#include "collision_monitor/pipeline/run_cycle.h"

namespace collision_monitor {

LinkPoses makeLinkPoses(const RobotModel& model) {
  LinkPoses poses;
  poses.world_from_link.resize(model.links.size());
  poses.status.resize(model.links.size(), LinkStatus::missing);
  poses.age.resize(model.links.size(), 0.0);
  return poses;
}

void placeBodies(const CycleSetup& setup, const LinkPoses& poses, BodyPoses& body_poses) noexcept {
  for (std::size_t link = 0; link < poses.status.size(); ++link) {
    // Checked here as well as at the edge: a NaN that slips through must read as unknown.
    const bool known =
        poses.status[link] == LinkStatus::known && isRigid(poses.world_from_link[link]);
    body_poses.link_known[link] = known ? 1 : 0;
  }
  for (std::size_t i = 0; i < setup.bodies.size(); ++i) {
    const Body& body = setup.bodies[i];
    body_poses.known[i] = body_poses.link_known[index(body.link)];
    if (body_poses.known[i] != 0) {
      body_poses.world_from_body[i] = poses.world_from_link[index(body.link)] * body.link_from_body;
    }
  }
}

void boundBodies(const CycleSetup& setup, const BodyPoses& body_poses, double reach,
                 BodyBounds& bounds) noexcept {
  for (std::size_t i = 0; i < setup.bodies.size(); ++i) {
    bounds.known[i] = body_poses.known[i];
    if (bounds.known[i] != 0) {
      bounds.boxes[i] = aabbOf(setup.bodies[i].shape, body_poses.world_from_body[i], 0.5 * reach);
    }
  }
}

}  // namespace collision_monitor
