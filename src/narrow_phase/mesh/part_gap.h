// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "narrow_phase/mesh/mesh_search.h"

/// How far the convex hulls of two parts of meshes are apart. Hulls of parts hug a surface that is
/// not flat far better than boxes do, so a search that asks them opens few nodes.
namespace collision_monitor {

/// A lower bound of the distance of two parts.
struct PartGap {
  double gap;                 ///< [m]
  Eigen::Vector3d direction;  ///< unit, from A to B in A's frame: it separates them by `gap`
  std::uint32_t visits;       ///< the time it took, in opened nodes
};

/// Whether both slots hold parts, see PartCorners.
bool areParts(const MeshPair& pair, Slot a, Slot b) noexcept;

/// [m] How far a direction of any length, from A to B in A's frame, separates two parts.
/// @pre areParts
double gapOfParts(const MeshPair& pair, Slot a, Slot b, const Eigen::Vector3d& direction) noexcept;

/// Looks for a direction that separates two parts by more than `goal` [m]. The search ends once
/// there is one, or cannot be.
/// Source: GJK, as runGjk; the closest features of convex hulls of nodes as their bounds: Ehmann,
/// Lin, "Accurate and Fast Proximity Queries Between Polyhedra Using Convex Surface Decomposition"
/// (2001). Departure: supports come from the corners themselves, and no hull is built.
/// @pre areParts
PartGap searchGapOfParts(const MeshPair& pair, Slot a, Slot b, double goal) noexcept;

}  // namespace collision_monitor
