// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/broad_phase/small_box.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "broad_phase/round_outward.h"

namespace collision_monitor {
namespace {

constexpr float kGreatest = std::numeric_limits<float>::max();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Between one and two units in the last place, also for 0; infinite at the greatest number. Always
/// applied: testing whether rounding went inward costs more.
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

/// False also for NaN.
bool isBox(const Aabb& box) noexcept {
  bool is_box = true;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    is_box &= box.min[axis] <= box.max[axis];
  }
  return is_box;
}

}  // namespace

SmallBox emptyBox() noexcept { return kEmpty; }

bool isEmpty(const SmallBox& box) noexcept { return std::isnan(box.min[0]); }

SmallBox smallBoxOf(const Aabb& box) noexcept {
  if (!isBox(box)) {
    return kEmpty;
  }
  return {{roundedDown(box.min.x()), roundedDown(box.min.y()), roundedDown(box.min.z()), 0.0F},
          {roundedUp(box.max.x()), roundedUp(box.max.y()), roundedUp(box.max.z()), 0.0F}};
}

void fillSmallBoxes(const BodyBounds& bounds, std::vector<SmallBox>& boxes) noexcept {
  static_assert(sizeof(Aabb) == 6 * sizeof(double) && sizeof(SmallBox) == 8 * sizeof(float));
  if (boxes.empty()) {
    return;
  }
  // Leaves out the last box, because no number follows it.
  roundOutward(bounds.boxes.front().min.data(), boxes.size() - 1, boxes.front().min.data());
  boxes.back() = smallBoxOf(bounds.boxes.back());
  for (std::size_t body = 0; body < boxes.size(); ++body) {
    if (bounds.known[body] == 0 || !isBox(bounds.boxes[body])) {
      boxes[body] = kEmpty;
    } else {
      boxes[body].min[3] = boxes[body].max[3] = 0.0F;
    }
  }
}

}  // namespace collision_monitor
