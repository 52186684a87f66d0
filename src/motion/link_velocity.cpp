// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/motion/link_velocity.h"

#include <cmath>

#include "collision_monitor/motion/screw_motion.h"

namespace collision_monitor {

Twist twistBetween(const Pose& before, const Pose& after, double duration) noexcept {
  const ScrewMotion motion = screwBetween(before, after);
  return twistAbout(before.translation, motion.travel / duration, motion.turn / duration);
}

Twist smoothed(const Twist& before, const Twist& now, double duration,
               double time_constant) noexcept {
  const double share = time_constant > 0.0 ? -std::expm1(-duration / time_constant) : 1.0;
  return before + share * (now - before);
}

}  // namespace collision_monitor
