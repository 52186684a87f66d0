// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/mesh_tree.h"

namespace collision_monitor {

/// Makes a slot empty: its bounds are so far away that no query meets them.
void boundNothing(std::uint32_t slot, MeshTreeNode& node) noexcept;

/// Sets the box of a slot, about `origin`.
/// @param low, high the least and greatest coordinates about `origin`, each the float nearest to a
/// difference of doubles of at most `size`. The box is grown by that rounding error.
void boundByBox(const Eigen::Vector3f& low, const Eigen::Vector3f& high, double size,
                std::uint32_t slot, MeshTreeNode& node) noexcept;

/// The triangles [first, last).
struct TriangleSpan {
  const Triangle* first;
  const Triangle* last;
};

/// Sets the slab of a slot across `direction`, which need not be unit and may be 0.
/// Frames: the triangles' axes, with the origin at `origin`.
/// @pre the span is not empty.
void boundBySlab(const TriangleSpan& triangles, const Eigen::Vector3d& direction,
                 const Eigen::Vector3d& origin, std::uint32_t slot, MeshTreeNode& node) noexcept;

}  // namespace collision_monitor
