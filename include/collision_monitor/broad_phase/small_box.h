// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "collision_monitor/broad_phase/body_bounds.h"

namespace collision_monitor {

/// An axis-aligned box in single precision, rounded outward. It holds the box it was made from, so
/// it may meet too many boxes and never too few. It takes half the memory of an Aabb, and vector
/// code tests twice as many at once. World frame, [m]. The fourth coordinates are 0.
struct alignas(32) SmallBox {
  std::array<float, 4> min{};  ///< x, y, z of the lower corner, then 0
  std::array<float, 4> max{};  ///< x, y, z of the upper corner, then 0
};

/// A box of NaN, which meets nothing, not even itself.
SmallBox emptyBox() noexcept;
bool isEmpty(const SmallBox& box) noexcept;  ///< whether the box meets nothing, as emptyBox()

/// The box rounded outward. Empty if a coordinate is NaN or min > max.
/// Error: between half a unit and 3 units in the last place of single precision outward.
/// Limits: an infinite coordinate, or one beyond single precision, becomes infinite where that is
/// outward, and the greatest finite number where it is not.
SmallBox smallBoxOf(const Aabb& box) noexcept;

/// Fills one box per body; bodies that are not known get an empty one.
/// @pre `boxes` and `bounds` have the same size.
void fillSmallBoxes(const BodyBounds& bounds, std::vector<SmallBox>& boxes) noexcept;

}  // namespace collision_monitor
