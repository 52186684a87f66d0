// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/look_ahead/bound_bodies.h"

#include <cmath>

#include "collision_monitor/geometry/bounds.h"
#include "motion/screw_motion.h"

namespace collision_monitor {

void boundBodies(const CycleSetup& setup, const BodyPoses& body_poses, double reach,
                 BodyBounds& bounds) noexcept {
  forIndices(body_poses.moved.bodies, [&](std::size_t i) noexcept {
    bounds.known[i] = body_poses.known[i];
    if (bounds.known[i] != 0) {
      bounds.boxes[i] = aabbOf(setup.bodies[i].shape, body_poses.world_from_body[i], 0.5 * reach);
    }
  });
}

void sweepBounds(const CycleSetup& setup, const BodyPoses& body_poses, const SweepWork& work,
                 double reach, BodyBounds& bounds) noexcept {
  constexpr double kShort = 0.1;  // share of `reach`: growing to all sides is good enough
  forIndices(body_poses.moved.bodies, [&](std::size_t i) noexcept {
    const double travel = work.body_travel[i];
    if (bounds.known[i] == 0 || !(travel > 0.0)) {
      return;
    }
    if (travel <= kShort * reach) {
      bounds.boxes[i].min.array() -= travel;
      bounds.boxes[i].max.array() += travel;
    } else {
      const Body& body = setup.bodies[i];
      const ScrewMotion motion =
          carriedBy(work.link_motions[index(body.link)], body.link_from_body);
      bounds.boxes[i] = sweptAabbOf(body.shape, motion, body_poses.world_from_body[i], 0.5 * reach);
    }
  });
}

Twist sharedTwist(const CycleSetup& setup, const LinkVelocities& velocities) noexcept {
  const std::size_t root = index(setup.model.robots.front().root);
  const bool is_shared = velocities.known[root] != 0 && isFinite(velocities.of_link[root]);
  return is_shared ? velocities.of_link[root] : Twist();
}

double travelAhead(const CycleSetup& setup, const LinkPoses& poses, const Body& body,
                   const Twist& shared, double duration) noexcept {
  const std::size_t link = index(body.link);
  if (poses.velocities.known[link] == 0) {
    return kUnknown;
  }
  const std::size_t root = index(setup.model.robots.front().root);
  const Twist& twist = poses.velocities.of_link[link];
  const Twist own = poses.part[link] == poses.part[root] ? twist - shared : twist;
  const Eigen::Vector3d center = poses.world_from_link[link] * body.link_from_body.translation;
  const double speed = velocityAt(own, center).norm() + own.angular.norm() * body.bounding_radius;
  return std::isfinite(speed) ? speed * duration : kUnknown;
}

void lookAhead(const CycleSetup& setup, const LinkPoses& poses, const BodyPoses& body_poses,
               double duration, BodyBounds& bounds) noexcept {
  // Many objects at rest keep their bounds, so these are seen from the world.
  const Twist shared = setup.carried.empty() ? sharedTwist(setup, poses.velocities) : Twist();
  forIndices(body_poses.moved.bodies, [&](std::size_t i) noexcept {
    bounds.ahead[i] = body_poses.known[i] == 0
                          ? kUnknown
                          : travelAhead(setup, poses, setup.bodies[i], shared, duration);
  });
}

void growBounds(const BodyPoses& body_poses, BodyBounds& bounds) noexcept {
  forIndices(body_poses.moved.bodies, [&](std::size_t i) noexcept {
    if (std::isfinite(bounds.ahead[i])) {
      bounds.boxes[i].min.array() -= bounds.ahead[i];
      bounds.boxes[i].max.array() += bounds.ahead[i];
    }
  });
}

}  // namespace collision_monitor
