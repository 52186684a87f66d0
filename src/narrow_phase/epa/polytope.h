// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/narrow_phase/convex_workspace.h"

/// EPA's polytope as faces with neighbors.
namespace collision_monitor {

/// Makes a tetrahedron of four vertices in any order. Its faces look outward.
void startPolytope(const std::array<SupportVertex, 4>& corners, ConvexWorkspace& polytope) noexcept;

enum class Growth : unsigned char {
  grown,
  full,     ///< no room; unchanged
  refused,  ///< rounding: the faces that see the vertex form no disc; unchanged
};

/// Adds a vertex that `face` sees: removes the faces that see it and joins it to their outline. A
/// face sees what is above its plane by more than `rounding`, so vertices in its plane do not tear
/// the polytope.
Growth grow(const SupportVertex& vertex, std::size_t face, double rounding,
            ConvexWorkspace& polytope) noexcept;

}  // namespace collision_monitor
