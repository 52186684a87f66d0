// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/look_ahead/find_closings.h"

#include <cmath>

#include "motion/closing.h"

namespace collision_monitor {

void findClosing(const CycleSetup& setup, const LinkPoses& poses, PairDistance& distance) noexcept {
  const LinkVelocities& velocities = poses.velocities;
  const CheckedLinkPair& pair = setup.checked[setup.link_pair_of[index(distance.pair)]];
  const std::size_t a = index(pair.a);
  const std::size_t b = index(pair.b);
  // The rate is not finite if a velocity is not finite.
  const double rate =
      velocities.known[a] != 0 && velocities.known[b] != 0
          ? distanceRate(distance.measured, velocities.of_link[a], velocities.of_link[b])
          : kUnknown;
  distance.closing_speed = std::isfinite(rate) ? -rate : kUnknown;
  distance.time_to_contact =
      timeToContact(distance.measured.distance - limitsOf(setup, pair).contact_distance,
                    distance.closing_speed, setup.ahead.horizon);
}

void findClosings(const CycleSetup& setup, const LinkPoses& poses,
                  PairDistances& distances) noexcept {
  for (PairDistance& distance : distances.pairs) {
    findClosing(setup, poses, distance);
  }
}

}  // namespace collision_monitor
