// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "broad_phase/spread.h"

#include <algorithm>
#include <cmath>

#include "broad_phase/box_tests.h"

namespace collision_monitor {

std::array<Spread, 3> spreadsOf(const std::vector<SmallBox>& boxes) noexcept {
  constexpr std::size_t kSamples = 4096;
  const std::size_t stride = 1 + boxes.size() / kSamples;
  std::array<Spread, 3> spreads;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double count = 0.0;
    double widths = 0.0;
    double sum = 0.0;
    double squares = 0.0;
    for (std::size_t body = 0; body < boxes.size(); body += stride) {
      const SmallBox& box = boxes[body];
      const double width = static_cast<double>(box.max[axis]) - box.min[axis];
      if (std::isfinite(width)) {
        const double center = centerOf(box, axis);
        count += 1.0;
        widths += width;
        sum += center;
        squares += center * center;
      }
    }
    if (count > 0.0) {
      const double mean = sum / count;
      const double variance = std::max(0.0, squares / count - mean * mean);
      spreads[axis] = {widths / count, std::sqrt(12.0 * variance)};
    }
  }
  return spreads;
}

}  // namespace collision_monitor
