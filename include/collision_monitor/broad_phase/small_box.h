// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "collision_monitor/broad_phase/body_bounds.h"

namespace collision_monitor {

/// An axis-aligned box in single precision, rounded outward: it holds the box it was made from, so
/// what it meets may be too much and is never too little. Half the size of an Aabb, twice as
/// many at a time in vector code. World frame, [m]. The fourth coordinates are 0.
struct alignas(32) SmallBox {
  std::array<float, 4> min{};
  std::array<float, 4> max{};
};

/// Meets nothing, itself neither: all coordinates are NaN.
SmallBox emptyBox() noexcept;
bool isEmpty(const SmallBox& box) noexcept;

/// Empty where the box is none: a coordinate is NaN, or min > max.
/// Error: between half a unit and 3 units in the last place of single precision outward.
/// Limits: infinite coordinates and those beyond single precision stay or become infinite outward,
/// and inward the greatest number.
SmallBox smallBoxOf(const Aabb& box) noexcept;

/// One a body; empty for those that are not known.
/// @pre `boxes` has as many as `bounds`.
void fillSmallBoxes(const BodyBounds& bounds, std::vector<SmallBox>& boxes) noexcept;

}  // namespace collision_monitor
