// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "motion/link_velocity.h"

#include <cmath>

#include "motion/screw_motion.h"

namespace collision_monitor {

Twist twistBetween(const Pose& before, const Pose& after, double duration) noexcept {
  const ScrewMotion motion = screwBetween(before, after);
  return twistAbout(before.translation, motion.travel / duration, motion.turn / duration);
}

double smoothingShare(double duration, double time_constant) noexcept {
  return time_constant > 0.0 ? -std::expm1(-duration / time_constant) : 1.0;
}

}  // namespace collision_monitor
