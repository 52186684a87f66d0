// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "broad_phase/pair_keys.h"
#include "collision_monitor/broad_phase/small_box.h"

namespace collision_monitor::test {

using Boxes = std::vector<SmallBox>;
using Meetings = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// [m] From 0 to 1 in y and z.
inline SmallBox boxAlongX(float min, float max) {
  return {{min, 0.0F, 0.0F, 0.0F}, {max, 1.0F, 1.0F, 0.0F}};
}

/// Boxes 1.25 m long whose lower ends are 1 m apart: each meets the next and no other.
inline Boxes chainOfBoxes(std::size_t count) {
  Boxes boxes;
  for (std::size_t i = 0; i < count; ++i) {
    boxes.push_back(boxAlongX(static_cast<float>(i), static_cast<float>(i) + 1.25F));
  }
  return boxes;
}

inline void moveAlongX(float travel, Boxes& boxes) {
  for (SmallBox& box : boxes) {
    box.min[0] += travel;
    box.max[0] += travel;
  }
}

/// In the order in which the method finds them.
template <class Method>
Meetings meetingsInOrder(Method& method, const Boxes& boxes) {
  std::vector<PairKey> found;
  method.findMeetings(boxes, found);
  Meetings meetings;
  for (const PairKey pair : found) {
    meetings.emplace_back(lowerBody(pair), upperBody(pair));
  }
  return meetings;
}

/// Sorted.
template <class Method>
Meetings meetingsOf(Method& method, const Boxes& boxes) {
  Meetings meetings = meetingsInOrder(method, boxes);
  std::sort(meetings.begin(), meetings.end());
  return meetings;
}

}  // namespace collision_monitor::test
