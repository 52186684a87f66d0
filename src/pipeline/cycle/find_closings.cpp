// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "motion/closing.h"
#include "pipeline/cycle/run_cycle.h"

namespace collision_monitor {

void growBounds(const CycleSetup& setup, const LinkPoses& poses, double duration,
                BodyBounds& bounds) noexcept {
  const LinkVelocities& velocities = poses.velocities;
  const std::size_t root = index(setup.model.robots.front().root);
  const bool is_shared = velocities.known[root] != 0 && isFinite(velocities.of_link[root]);
  const Twist shared = is_shared ? velocities.of_link[root] : Twist();
  for (std::size_t i = 0; i < setup.bodies.size(); ++i) {
    const Body& body = setup.bodies[i];
    const std::size_t link = index(body.link);
    bounds.ahead[i] = kUnknown;
    if (bounds.known[i] == 0 || velocities.known[link] == 0) {
      continue;
    }
    const bool has_shared = poses.part[link] == poses.part[root];
    const Twist own = has_shared ? velocities.of_link[link] - shared : velocities.of_link[link];
    const Eigen::Vector3d center = poses.world_from_link[link] * body.link_from_body.translation;
    const double speed = velocityAt(own, center).norm() + own.angular.norm() * body.bounding_radius;
    if (std::isfinite(speed)) {
      bounds.ahead[i] = speed * duration;
      bounds.boxes[i].min.array() -= bounds.ahead[i];
      bounds.boxes[i].max.array() += bounds.ahead[i];
    }
  }
}

void findClosings(const CycleSetup& setup, const LinkPoses& poses,
                  PairDistances& distances) noexcept {
  const LinkVelocities& velocities = poses.velocities;
  for (PairDistance& distance : distances.measured) {
    const CheckedLinkPair& pair = setup.checked[setup.link_pair_of[index(distance.pair)]];
    const std::size_t a = index(pair.a);
    const std::size_t b = index(pair.b);
    // A rate that is not finite is a velocity that was not, either.
    const double rate =
        velocities.known[a] != 0 && velocities.known[b] != 0
            ? distanceRate(distance.measured, velocities.of_link[a], velocities.of_link[b])
            : kUnknown;
    distance.closing_speed = std::isfinite(rate) ? -rate : kUnknown;
    distance.time_to_contact =
        timeToContact(distance.measured.distance - setup.limits.contact_distance,
                      distance.closing_speed, setup.ahead.horizon);
  }
}

}  // namespace collision_monitor
