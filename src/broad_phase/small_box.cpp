// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/broad_phase/small_box.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace collision_monitor {
namespace {

constexpr float kGreatest = std::numeric_limits<float>::max();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// At least one unit in the last place, also of 0, and at most two; beyond the greatest number one
/// step is infinite. Taken always: to ask whether rounding went the wrong way costs more.
float stepOf(float value) noexcept {
  return std::abs(value) * std::numeric_limits<float>::epsilon() +
         std::numeric_limits<float>::min();
}

float nearest(double value) noexcept {
  return static_cast<float>(
      std::clamp(value, -static_cast<double>(kGreatest), static_cast<double>(kGreatest)));
}

float roundedDown(double value) noexcept {
  const float rounded = nearest(value);
  return rounded - stepOf(rounded);
}

float roundedUp(double value) noexcept {
  const float rounded = nearest(value);
  return rounded + stepOf(rounded);
}

constexpr SmallBox kEmpty{{kNan, kNan, kNan, kNan}, {kNan, kNan, kNan, kNan}};

/// In here and not in smallBoxOf, so that it can become part of the loop over all bodies.
SmallBox roundedOutward(const Aabb& box) noexcept {
  SmallBox small;
  bool is_box = true;  // not where a coordinate is NaN
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    small.min[static_cast<std::size_t>(axis)] = roundedDown(box.min[axis]);
    small.max[static_cast<std::size_t>(axis)] = roundedUp(box.max[axis]);
    is_box &= box.min[axis] <= box.max[axis];
  }
  return is_box ? small : kEmpty;
}

}  // namespace

SmallBox emptyBox() noexcept { return kEmpty; }

bool isEmpty(const SmallBox& box) noexcept { return std::isnan(box.min[0]); }

SmallBox smallBoxOf(const Aabb& box) noexcept { return roundedOutward(box); }

void fillSmallBoxes(const BodyBounds& bounds, std::vector<SmallBox>& boxes) noexcept {
  for (std::size_t body = 0; body < boxes.size(); ++body) {
    boxes[body] = bounds.known[body] != 0 ? roundedOutward(bounds.boxes[body]) : kEmpty;
  }
}

}  // namespace collision_monitor
