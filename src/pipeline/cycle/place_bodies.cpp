// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/cycle/place_bodies.h"

#include <algorithm>

#include "collision_monitor/geometry/bounds.h"
#include "pipeline/blocks/contact_of_pairs.h"
#include "pipeline/objects/find_resting.h"

namespace collision_monitor {
namespace {

/// Writes world_from_link * link_from_part. x and y go together: compilers that pair numbers across
/// columns shuffle more than they compute.
void place(const Pose& world_from_link, const Pose& link_from_part,
           Pose& world_from_part) noexcept {
  using Pair = Eigen::Vector2d;
  const Eigen::Matrix3d& r = world_from_link.rotation;
  const Pair xy[] = {r.col(0).head<2>(), r.col(1).head<2>(), r.col(2).head<2>()};
  const double z[] = {r(2, 0), r(2, 1), r(2, 2)};
  const auto turn = [&](const auto& v, auto&& turned) {
    const Pair turned_xy = xy[0] * v[0] + xy[1] * v[1] + xy[2] * v[2];
    turned[2] = z[0] * v[0] + z[1] * v[1] + z[2] * v[2];
    turned.template head<2>() = turned_xy;
  };
  for (Eigen::Index i = 0; i < 3; ++i) {
    turn(link_from_part.rotation.col(i), world_from_part.rotation.col(i));
  }
  turn(link_from_part.translation, world_from_part.translation);
  world_from_part.translation += world_from_link.translation;
}

/// Checked here as well as at the ROS edge: NaN must always read as unknown.
bool isKnown(const LinkPoses& poses, std::size_t link) noexcept {
  return poses.status[link] == LinkStatus::known && isRigid(poses.world_from_link[link]);
}

/// Marks links that float alone as unknown: there is nothing to measure them against.
void leaveLoneLinks(BodyPoses& body_poses) noexcept {
  std::vector<std::uint32_t>& count = body_poses.links_of_part;
  std::fill(count.begin(), count.end(), 0U);
  const auto floats = [&](std::size_t link) {
    return body_poses.link_known[link] != 0 && body_poses.part[link] != kWorldPart;
  };
  for (std::size_t link = 0; link < count.size(); ++link) {
    if (floats(link)) {
      ++count[body_poses.part[link]];
    }
  }
  for (std::size_t link = 0; link < count.size(); ++link) {
    if (floats(link) && count[body_poses.part[link]] < 2) {
      body_poses.link_known[link] = 0;
    }
  }
}

/// Whether known links are in several parts.
bool isSplit(const BodyPoses& body_poses) noexcept {
  const auto& known = body_poses.link_known;
  const auto first =
      static_cast<std::size_t>(std::find(known.begin(), known.end(), 1) - known.begin());
  for (std::size_t link = first; link < known.size(); ++link) {
    if (known[link] != 0 && body_poses.part[link] != body_poses.part[first]) {
      return true;
    }
  }
  return false;
}

/// Fills which links are known, and in which parts.
void findLinks(const CycleSetup& setup, const LinkPoses& poses, BodyPoses& body_poses) noexcept {
  bool floats = false;
  forIndices(body_poses.moved.bodies, [&](std::size_t i) noexcept {
    const std::size_t link = index(setup.bodies[i].link);
    if (i == 0 || setup.bodies[i - 1].link != setup.bodies[i].link) {
      body_poses.link_known[link] = isKnown(poses, link) ? 1 : 0;
      body_poses.part[link] = poses.part[link];
      floats = floats || poses.part[link] != kWorldPart;
    }
  });
  if (floats) {
    leaveLoneLinks(body_poses);
  }
  body_poses.is_split = floats && isSplit(body_poses);
}

}  // namespace

LinkPoses makeLinkPoses(const RobotModel& model) {
  LinkPoses poses;
  poses.world_from_link.resize(model.links.size());
  poses.status.resize(model.links.size(), LinkStatus::missing);
  poses.part.resize(model.links.size(), kWorldPart);
  poses.part_status.resize(model.links.size(), LinkStatus::known);
  poses.age.resize(model.links.size(), 0.0);
  poses.robot_stamp_ns.resize(model.robots.size(), 0);
  poses.velocities.of_link.resize(model.links.size());
  poses.velocities.known.resize(model.links.size(), 0);
  return poses;
}

void placeBodies(const CycleSetup& setup, const LinkPoses& poses, BodyPoses& body_poses) noexcept {
  const std::vector<Body>& bodies = setup.bodies;
  findLinks(setup, poses, body_poses);
  forIndices(body_poses.moved.bodies, [&](std::size_t i) noexcept {
    const std::size_t link = index(bodies[i].link);
    const Pose& world_from_link = poses.world_from_link[link];
    const std::size_t slot = setup.blocks.slot_of[i];
    body_poses.known[i] = body_poses.link_known[link];
    if (body_poses.known[i] == 0) {
      loseBody(slot, body_poses.rows);
      return;
    }
    place(world_from_link, bodies[i].link_from_body, body_poses.world_from_body[i]);
    body_poses.balls[i].center = body_poses.world_from_body[i].translation;
    writeBody(setup.cores[i].kind, body_poses.world_from_body[i], slot, body_poses.rows);
  });
}

void placeElements(const CycleSetup& setup, const LinkPoses& poses,
                   BodyPoses& body_poses) noexcept {
  forIndices(body_poses.moved.elements, [&](std::size_t i) noexcept {
    const Element& element = setup.elements[i];
    if (body_poses.link_known[index(element.link)] != 0) {
      place(poses.world_from_link[index(element.link)], element.link_from_element,
            body_poses.world_from_element[i]);
    }
  });
}

BodyPoses makeBodyPoses(const CycleSetup& setup) {
  BodyPoses body_poses;
  moveAll(setup, body_poses.moved);
  body_poses.world_from_body.resize(setup.bodies.size());
  std::vector<double> bounding_radii;
  for (const Body& body : setup.bodies) {
    bounding_radii.push_back(body.bounding_radius);
    body_poses.balls.push_back({Eigen::Vector3d::Zero(), body.bounding_radius});
  }
  body_poses.rows = makeBodyRows(setup.blocks, setup.cores, bounding_radii);
  body_poses.known.resize(setup.bodies.size(), 0);
  body_poses.link_known.resize(setup.model.links.size(), 0);
  body_poses.part.resize(setup.model.links.size(), kWorldPart);
  body_poses.links_of_part.resize(setup.model.links.size(), 0);
  body_poses.world_from_element.resize(setup.elements.size());
  return body_poses;
}

}  // namespace collision_monitor
