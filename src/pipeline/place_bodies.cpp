// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "collision_monitor/geometry/bounds.h"
#include "collision_monitor/pipeline/run_cycle.h"

namespace collision_monitor {
namespace {

/// world_from_link * link_from_part. Written where it is to stand: the copy of a pose that was just
/// written number by number stalls the processor for longer than the product takes.
void place(const Pose& world_from_link, const Pose& link_from_part,
           Pose& world_from_part) noexcept {
  world_from_part.rotation.noalias() = world_from_link.rotation * link_from_part.rotation;
  world_from_part.translation.noalias() = world_from_link.rotation * link_from_part.translation;
  world_from_part.translation += world_from_link.translation;
}

}  // namespace

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
  const std::vector<Body>& bodies = setup.bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const std::size_t link = index(bodies[i].link);
    const Pose& world_from_link = poses.world_from_link[link];
    if (i == 0 || bodies[i - 1].link != bodies[i].link) {
      // Checked here as well as at the edge: a NaN that slips through must read as unknown.
      const bool known = poses.status[link] == LinkStatus::known && isRigid(world_from_link);
      body_poses.link_known[link] = known ? 1 : 0;
    }
    const std::size_t slot = setup.blocks.slot_of[i];
    body_poses.known[i] = body_poses.link_known[link];
    if (body_poses.known[i] == 0) {
      loseBody(slot, body_poses.rows);
      continue;
    }
    place(world_from_link, bodies[i].link_from_body, body_poses.world_from_body[i]);
    writeBody(setup.cores[i].kind, body_poses.world_from_body[i], slot, body_poses.rows);
  }
}

void placeElements(const CycleSetup& setup, const LinkPoses& poses,
                   BodyPoses& body_poses) noexcept {
  for (std::size_t i = 0; i < setup.elements.size(); ++i) {
    const Element& element = setup.elements[i];
    if (body_poses.link_known[index(element.link)] != 0) {
      place(poses.world_from_link[index(element.link)], element.link_from_element,
            body_poses.world_from_element[i]);
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

ContactDistances contactDistancesOf(const CycleSetup& setup) {
  ContactDistances limits;
  for (const std::uint32_t link_pair : setup.link_pair_of) {
    limits.of_pair.push_back(setup.checked[link_pair].limits.contact_distance);
    limits.largest = std::max(limits.largest, limits.of_pair.back());
  }
  return limits;
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
