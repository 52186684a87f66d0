// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "collision_monitor/broad_phase/small_box.h"

namespace collision_monitor {

/// True when the boxes overlap or touch; false for empty ones. All six comparisons are made,
/// because a branch is hard to predict and a wrong guess costs more than the comparisons it saves.
inline bool meets(const SmallBox& a, const SmallBox& b) noexcept {
  bool meet = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    meet &= a.min[axis] <= b.max[axis];
    meet &= b.min[axis] <= a.max[axis];
  }
  return meet;
}

/// An empty box is inside every box; only an empty box is inside an empty one.
inline bool isInside(const SmallBox& inner, const SmallBox& outer) noexcept {
  bool is_inside = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    is_inside &= outer.min[axis] <= inner.min[axis];
    is_inside &= inner.max[axis] <= outer.max[axis];
  }
  return is_inside || isEmpty(inner);
}

/// The smallest box that holds both.
/// @pre neither is empty.
inline SmallBox unionOf(const SmallBox& a, const SmallBox& b) noexcept {
  SmallBox both;
  for (std::size_t i = 0; i < both.min.size(); ++i) {
    both.min[i] = std::min(a.min[i], b.min[i]);
    both.max[i] = std::max(a.max[i], b.max[i]);
  }
  return both;
}

/// Center of the box along one axis. Units: metres. Finite also for infinite boxes.
inline double centerOf(const SmallBox& box, std::size_t axis) noexcept {
  constexpr double kFar = 1e18;
  return 0.5 * (std::max<double>(box.min[axis], -kFar) + std::min<double>(box.max[axis], kFar));
}

}  // namespace collision_monitor
