// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "motion/relative_motion.h"
#include "narrow_phase/mesh/mesh_distance.h"

namespace collision_monitor {

/// Whether two meshes stay apart during a motion.
struct MeshClearance {
  bool is_proven{false};
  double at_least{0.0};     ///< [m] if proven: they stay at least this far apart, up to rounding
  std::uint32_t visits{0};  ///< as MeshDistance::visits
};

/// Proves that two meshes stay farther apart than a distance during a motion, and that neither
/// comes to hold a point of the other.
///
/// A plane with a fixed normal n parts two convex sets as long as their gap along n exceeds what
/// their points move along n. So surfaces that slide along each other stay apart however far they
/// slide. Descends both hierarchies until a ball about a node moves too little, or a direction that
/// parted other triangles parts the nodes. Stops at the first triangles that nothing parts.
///
/// Frames: world, in the middle of the interval. Units: metres.
/// Limits: not proven does not mean that they come near. Shorter intervals are easier to prove.
/// Source: Zhang, Lee, Kim, "Interactive continuous collision detection for non-convex polyhedra"
/// (2006), for motion bounds along a direction; Tang, Kim, Manocha, "C2A" (2009), for bounds of
/// nodes.
/// @param motion of B seen from A
/// @param distance [m] 0 or more
MeshClearance stayApart(const PlacedMesh& a, const PlacedMesh& b, const RelativeMotion& motion,
                        double distance, MeshQueryMemory& memory) noexcept;

}  // namespace collision_monitor
