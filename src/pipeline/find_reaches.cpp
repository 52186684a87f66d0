// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "collision_monitor/pipeline/motion_bound.h"
#include "collision_monitor/pipeline/run_cycle.h"

namespace collision_monitor {
namespace {

/// [m] How far any point of a link's ball may have come since the last cycle.
double wayOf(const ScrewMotion& motion, const Ball& ball) noexcept {
  return velocityAt(motion, ball.center).norm() + motion.turn.norm() * ball.radius;
}

/// As norm(), which would stall on reading back as vectors what was just written.
double lengthOf(const Eigen::Vector3d& v) noexcept {
  return std::sqrt(v.x() * v.x() + v.y() * v.y() + v.z() * v.z());
}

}  // namespace

PairReaches makePairReaches(const CycleSetup& setup) {
  PairReaches reaches;
  reaches.link_balls = linkBalls(setup);
  reaches.centers.resize(setup.model.links.size(), Eigen::Vector3d::Zero());
  reaches.ways.resize(setup.model.links.size(), 0.0);
  reaches.of_pair.resize(setup.checked.size(), std::numeric_limits<double>::infinity());
  return reaches;
}

void findReaches(const CycleSetup& setup, const LinkPoses& poses, const SweepWork& sweep,
                 PairReaches& reaches) noexcept {
  for (std::size_t i = 0; i < reaches.centers.size(); ++i) {
    const Ball& ball = reaches.link_balls[i];
    reaches.centers[i] = poses.world_from_link[i] * ball.center;
    reaches.ways[i] = setup.is_continuous ? wayOf(sweep.link_motions[i], ball) : 0.0;
  }
  const LinkVelocities& velocities = poses.velocities;
  const double reach = reachOf(setup.limits);
  for (std::size_t i = 0; i < reaches.of_pair.size(); ++i) {
    const CheckedLinkPair& pair = setup.checked[i];
    const std::size_t a = index(pair.a);
    const std::size_t b = index(pair.b);
    const Twist twist = velocities.of_link[b] - velocities.of_link[a];
    const double speed = lengthOf(velocityAt(twist, reaches.centers[b])) +
                         lengthOf(twist.angular) * reaches.link_balls[b].radius;
    const double contact = pair.limits.contact_distance;
    const double asked =
        std::max(contact, setup.ahead.stop.stop_distance + pair.limits.hysteresis) +
        speed * setup.ahead.horizon;
    const bool is_known = velocities.known[a] != 0 && velocities.known[b] != 0;
    reaches.of_pair[i] = is_known && std::isfinite(asked)
                             ? std::max({reach, asked, contact + reaches.ways[a] + reaches.ways[b]})
                             : std::numeric_limits<double>::infinity();
  }
}

}  // namespace collision_monitor
