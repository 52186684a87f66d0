// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "narrow_phase/mesh_front/mesh_front.h"

namespace collision_monitor {

/// Numbers of ten bits, as `packed` makes them, stand about this.
constexpr std::int32_t kPackedBits = 10;
constexpr std::int32_t kPackedMiddle = 1 << (kPackedBits - 1);

/// How the moving mesh went on, seen from what rests: the point x, from the center of its tree,
/// by turn x + shift.
struct FrontStep {
  float turn[3][3];  ///< rows
  float shift[3];    ///< [m]
  float size;        ///< of `turn`: no unit vector goes farther
  float center_unit;
  float radius_unit;  ///< [m] one bit of the numbers in MeshFront::center and extent
  float slack;        ///< [m] taken from every bound
};

/// Loosens all bounds by a step, with the widest vector instructions the machine has; each of them
/// gives the same bits.
///
/// Of a pair with direction n, unit and in the frame of what rests, and a ball (c, r) about the one
/// that moves: all points of the ball go n.(turn x + shift) along n, which is linear in x, so the
/// gap along n grows by n.(turn c + shift) - r |turn^T n| at least. Without a direction it shrinks
/// by |turn c + shift| + r |turn| at most.
void loosen(const FrontStep& step, MeshFront& front) noexcept;

/// The first pair from a place on whose bound is below the goal; MeshFront::size if there is none.
std::uint32_t nextBelow(float goal, std::uint32_t from, const MeshFront& front) noexcept;

/// How many bounds are below the goal.
std::uint32_t countBelow(float goal, const MeshFront& front) noexcept;

/// [m] Infinity if there are none.
float leastBound(const MeshFront& front) noexcept;

}  // namespace collision_monitor
