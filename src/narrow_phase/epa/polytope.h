// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/narrow_phase/convex_workspace.h"

/// The polytope that EPA grows, as faces with neighbours.
namespace collision_monitor {

/// A tetrahedron of the first four vertices, outward whatever their order.
void startPolytope(const std::array<SupportVertex, 4>& corners, ConvexWorkspace& polytope) noexcept;

enum class Growth : unsigned char {
  grown,
  full,     ///< no room; unchanged
  refused,  ///< rounding makes the faces that see the vertex no disc; unchanged
};

/// Adds a vertex that `face` sees: takes away the faces that see it and joins it to their outline.
/// A face counts as seeing from `rounding` on, so that vertices in its plane do not tear it.
Growth grow(const SupportVertex& vertex, std::size_t face, double rounding,
            ConvexWorkspace& polytope) noexcept;

}  // namespace collision_monitor
