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
  poses.robot_stamp_ns.resize(model.robots.size(), 0);
  poses.velocities.of_link.resize(model.links.size());
  poses.velocities.known.resize(model.links.size(), 0);
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
  fillBodyRows(setup.blocks, setup.cores, body_poses.world_from_body, body_poses.known,
               body_poses.rows);
  for (std::size_t i = 0; i < setup.elements.size(); ++i) {
    const Element& element = setup.elements[i];
    if (body_poses.link_known[index(element.link)] != 0) {
      body_poses.world_from_element[i] =
          poses.world_from_link[index(element.link)] * element.link_from_element;
    }
  }
}

BodyPoses makeBodyPoses(const CycleSetup& setup) {
  BodyPoses body_poses;
  body_poses.world_from_body.resize(setup.bodies.size());
  std::vector<double> bounding_radii;
  for (const Body& body : setup.bodies) {
    bounding_radii.push_back(body.bounding_radius);
  }
  body_poses.rows = makeBodyRows(setup.blocks, setup.cores, bounding_radii);
  body_poses.known.resize(setup.bodies.size(), 0);
  body_poses.link_known.resize(setup.model.links.size(), 0);
  body_poses.world_from_element.resize(setup.elements.size());
  return body_poses;
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
