// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include "collision_monitor/narrow_phase/mesh_distance.h"

namespace collision_monitor {

/// What a search for the deepest corner of two meshes leaves for the next one about the same: the
/// corner, and the bounds at which the search stopped. Some thousands of bytes.
struct KeptDepth {
  /// Each opened node leaves seven others behind, on each level.
  static constexpr std::size_t kCapacity = 7 * (MeshTree::kMaxLevels + 1) + 8;

  struct Waiting {
    std::uint32_t bound;    ///< of the mesh whose corners are looked at: node and slot
    std::uint32_t nearest;  ///< a triangle of the other near to it
  };
  /// A search through the corners of one mesh.
  struct Side {
    std::uint32_t size{0};
    std::array<Waiting, kCapacity> waiting;
  };
  struct Corner {
    std::uint32_t triangle{TrianglePair::kNone};  ///< kNone: none is known to be inside
    std::uint32_t at{0};                          ///< which of the triangle's
    std::uint32_t nearest{TrianglePair::kNone};   ///< triangle of the other mesh
  };

  std::array<Side, 2> sides;  ///< corners of A in B, and of B in A
  std::size_t side{0};        ///< of the deepest corner
  Corner deepest;
  SignedDistance in_a;           ///< the last answer, in A's frame
  std::optional<Pose> a_from_b;  ///< of the last query; none: there was none
  double moved{0.0};             ///< [m] since the search from the roots began
};

/// How deep two meshes are in each other, at least: every translation that separates the solids
/// has to bring out the corner of either that is deepest inside the other.
struct MeshDepth {
  /// The corner and the point of the other surface nearest to it, as a contact; its normal is the
  /// local way out. Distance 0 where no corner of either is found inside the other, or a mesh has
  /// no inside.
  SignedDistance deepest;
  std::uint32_t points{0};  ///< measured
  bool is_complete{false};  ///< all corners were looked at where they are now
};

/// The deepest corner of two meshes that move: that of the last query, measured anew, or a deeper
/// one. The search for deeper ones goes on where it stopped, the further the more of the depth they
/// have moved by since the last query, and begins anew after a step longer than that, or where
/// nothing is kept.
///
/// Frames: world. Error: 1e-12 m for the corners looked at. While meshes move there may be deeper
/// corners than those, by twice the way since they last were looked at at most; once they stand the
/// answer becomes complete. A pose that is not finite gives distance 0, and leaves no trace.
/// Limits: two solids may cross with no corner of one in the other (crossed bars): the distance is
/// then 0 and says nothing. The budget counts points whose distance from the other mesh is searched
/// for, and may be exceeded by three. The same queries give the same answers.
/// Source: signed distance changes by no more than the way gone, so a node whose centre is not deep
/// enough for its size is passed over: Guthe, Borodin, Klein, "Fast and accurate Hausdorff distance
/// calculation between meshes" (2005), for such bounds; docs/decisions/mesh-depth.md.
/// @pre as distanceBetween. @param memory its content means nothing afterwards.
/// @param kept of the same meshes, or new. Changes the depth found, never that it is one.
MeshDepth depthOf(const PlacedMesh& a, const PlacedMesh& b, MeshQueryMemory& memory,
                  KeptDepth& kept, std::uint32_t point_budget) noexcept;

/// As new, for other places of the meshes.
void forget(KeptDepth& kept) noexcept;

}  // namespace collision_monitor
