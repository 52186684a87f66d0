// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include "collision_monitor/geometry/ids.h"
#include "narrow_phase/mesh/mesh_distance.h"

namespace collision_monitor {

/// What a search for the deepest corner of two meshes leaves for the next one: the corner, the
/// places that it passed over, and those still open. Some thousands of bytes.
struct KeptDepth {
  /// A search opens the whole mesh at least down to a triangle and leaves seven others on each
  /// level.
  static constexpr std::uint32_t kCapacity = 7 * (MeshTree::kMaxLevels + 1) + 16;

  /// A part of the mesh whose corners are looked at.
  struct Place {
    std::uint32_t bound;    ///< node and slot
    std::uint32_t nearest;  ///< a triangle of the other mesh near it
    double limit;           ///< [m] no corner is deeper than this plus `moved`
  };
  /// A search through the corners of one mesh. No limit covers the deepest corner of all, which
  /// each query measures.
  struct Side {
    std::uint32_t passed_over{0};  ///< number of places at the front: not deep enough
    std::uint32_t open_count{0};   ///< number of places at the back: still open, the next first
    bool is_whole{true};           ///< no place was dropped for lack of room
    double highest{0.0};           ///< [m] no limit of those passed over is higher
    std::array<Place, kCapacity> places;
  };
  struct Corner {
    std::uint32_t bound{kNone};    ///< of its triangle; kNone: none is known to be inside
    std::uint32_t at{0};           ///< which corner of the triangle
    std::uint32_t nearest{kNone};  ///< triangle of the other mesh
  };

  std::array<Side, 2> sides;  ///< corners of A in B, and of B in A
  std::size_t side{0};        ///< of the deepest corner
  Corner deepest;
  SignedDistance in_a;           ///< the last answer, in A's frame
  std::optional<Pose> a_from_b;  ///< of the last query, if there was one
  double moved{0.0};             ///< [m] travel since the search from the whole meshes began
};

/// A lower bound of how deep two meshes are in each other: every translation that separates the
/// solids brings out the deepest corner of either. It may leave an open solid through a hole.
struct MeshDepth {
  /// The corner and the closest point of the other surface, as a contact. The normal is the local
  /// way out. Distance 0 if no corner of either is found inside the other, or a mesh has no inside.
  SignedDistance deepest;
  std::uint32_t points{0};  ///< measured
  std::uint32_t visits{0};  ///< nodes opened for them
  bool is_complete{false};  ///< no corner is deeper
};

/// Finds the deepest corner of two moving meshes: that of the last query, measured again, or a
/// deeper one. Places passed over tell how far the meshes may travel before they can be deeper.
/// They are then looked at again, in order of need, with as many points as the budget and the step
/// since the last query allow. The search restarts after a step longer than the depth, or if
/// nothing is kept.
///
/// Frames: world. Error: 1e-12 m for the corners looked at. There may be deeper corners until the
/// answer is complete; it becomes so once the meshes stand still. A pose that is not finite gives
/// distance 0 and changes nothing. Limits: two solids may cross with no corner of one in the other
/// (crossed bars): the distance is then 0 and says nothing. The budget counts points whose distance
/// from the other mesh is searched, and may be exceeded by three. The same queries give the same
/// answers. Source: a signed distance changes by at most the travel. A node whose center is not
/// deep enough for its size is passed over until the meshes have traveled what it lacked: Guthe,
/// Borodin, Klein, "Fast and accurate Hausdorff distance calculation between meshes" (2005), for
/// such bounds; docs/decisions/mesh-depth.md.
/// @pre as distanceBetween. @param memory its content means nothing afterwards.
/// @param kept of the same meshes, or new. It changes the bound, never that it is one.
MeshDepth depthOf(const PlacedMesh& a, const PlacedMesh& b, MeshQueryMemory& memory,
                  KeptDepth& kept, std::uint32_t point_budget) noexcept;

/// Resets `kept`, for other poses of the meshes.
void forget(KeptDepth& kept) noexcept;

}  // namespace collision_monitor
