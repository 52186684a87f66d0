// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/pair_search/touch.h"

namespace collision_monitor {

Touch touchOf(const PairDistance& distance) noexcept {
  constexpr double kTouch = 1e-9;  // [m]
  if (distance.quality == Quality::estimate) {
    return Touch::touching;
  }
  if (distance.quality != Quality::unknown && distance.measured.distance > kTouch) {
    return Touch::apart;
  }
  return distance.quality == Quality::exact ? Touch::touching : Touch::unclear;
}

}  // namespace collision_monitor
