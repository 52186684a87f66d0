// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "motion/closing.h"

#include <cmath>
#include <limits>

namespace collision_monitor {

double timeToContact(double gap, double closing_speed, double horizon) noexcept {
  if (std::isnan(gap) || gap <= 0.0) {
    return std::isnan(gap) ? gap : 0.0;
  }
  if (std::isnan(closing_speed)) {
    return closing_speed;
  }
  return gap <= closing_speed * horizon ? gap / closing_speed
                                        : std::numeric_limits<double>::infinity();
}

}  // namespace collision_monitor
