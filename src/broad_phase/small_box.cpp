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

}  // namespace

SmallBox emptyBox() noexcept { return {{kNan, kNan, kNan, kNan}, {kNan, kNan, kNan, kNan}}; }

bool isEmpty(const SmallBox& box) noexcept { return std::isnan(box.min[0]); }

SmallBox smallBoxOf(const Aabb& box) noexcept {
  if (!(box.min.array() <= box.max.array()).all()) {  // also where one is NaN
    return emptyBox();
  }
  return {{roundedDown(box.min.x()), roundedDown(box.min.y()), roundedDown(box.min.z()), 0.0F},
          {roundedUp(box.max.x()), roundedUp(box.max.y()), roundedUp(box.max.z()), 0.0F}};
}

void fillSmallBoxes(const BodyBounds& bounds, std::vector<SmallBox>& boxes) noexcept {
  for (std::size_t body = 0; body < boxes.size(); ++body) {
    boxes[body] = bounds.known[body] != 0 ? smallBoxOf(bounds.boxes[body]) : emptyBox();
  }
}

}  // namespace collision_monitor
