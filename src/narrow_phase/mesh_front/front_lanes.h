// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "narrow_phase/mesh_front/mesh_front.h"

namespace collision_monitor {

/// Format of the numbers of `packed`: ten bits about this middle.
constexpr std::int32_t kPackedBits = 10;
constexpr std::int32_t kPackedMiddle = 1 << (kPackedBits - 1);

/// Motion of the moving mesh in one step, seen from what rests. A point x, relative to the center
/// of its tree, moves by turn x + shift.
struct FrontStep {
  float turn[3][3];   ///< rows
  float shift[3];     ///< [m]
  float size;         ///< of `turn`: no unit vector moves farther
  float center_unit;  ///< [m] one bit of MeshFront::center
  float radius_unit;  ///< [m] one bit of MeshFront::extent
  float slack;        ///< [m] subtracted from every bound
};

/// Loosens all bounds by a step. Uses the widest vector instructions of the machine; all give the
/// same bits.
///
/// Let a pair have direction n, unit and in the frame of what rests, and a ball (c, r) about its
/// moving side. A point x of the ball moves n.(turn x + shift) along n, which is linear in x. So
/// the gap along n grows by at least n.(turn c + shift) - r |turn^T n|. Without a direction it
/// shrinks by at most |turn c + shift| + r |turn|.
void loosen(const FrontStep& step, MeshFront& front) noexcept;

/// The first pair from index `from` on with a bound below the goal; MeshFront::size if none has.
std::uint32_t nextBelow(float goal, std::uint32_t from, const MeshFront& front) noexcept;

/// Number of bounds below the goal.
std::uint32_t countBelow(float goal, const MeshFront& front) noexcept;

/// [m] The least bound; infinity if there are no pairs.
float leastBound(const MeshFront& front) noexcept;

}  // namespace collision_monitor
