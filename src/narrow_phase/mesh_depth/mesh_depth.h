// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include "collision_monitor/geometry/ids.h"
#include "narrow_phase/mesh/mesh_distance.h"

namespace collision_monitor {

/// What a search for the deepest corner of two meshes leaves for the next one about the same: the
/// corner, and what the search passed over or has yet to look at. Some thousands of bytes.
struct KeptDepth {
  /// A search for one mesh's corners opens the whole mesh down to a triangle at least: seven others
  /// are left behind on each level.
  static constexpr std::uint32_t kCapacity = 7 * (MeshTree::kMaxLevels + 1) + 16;

  /// A part of the mesh whose corners are looked at.
  struct Place {
    std::uint32_t bound;    ///< node and slot
    std::uint32_t nearest;  ///< a triangle of the other mesh near to it
    double limit;           ///< [m] none of its corners is deeper than this and `moved`
  };
  /// A search through the corners of one mesh. The deepest of all is in none of the limits: it is
  /// measured in each query.
  struct Side {
    std::uint32_t passed_over{0};  ///< the first of the places: they were not deep enough
    std::uint32_t open_count{0};   ///< the last of them, the next one first
    bool is_whole{true};           ///< none was dropped for want of room
    double highest{0.0};           ///< [m] no limit of those passed over is more
    std::array<Place, kCapacity> places;
  };
  struct Corner {
    std::uint32_t bound{kNone};    ///< of its triangle; kNoBound: none is known to be inside
    std::uint32_t at{0};           ///< which of the triangle's
    std::uint32_t nearest{kNone};  ///< triangle of the other mesh
  };

  std::array<Side, 2> sides;  ///< corners of A in B, and of B in A
  std::size_t side{0};        ///< of the deepest corner
  Corner deepest;
  SignedDistance in_a;           ///< the last answer, in A's frame
  std::optional<Pose> a_from_b;  ///< of the last query; none: there was none
  double moved{0.0};             ///< [m] since the search from the whole meshes began
};

/// How deep two meshes are in each other, at least: every translation that separates the solids
/// has to bring out the corner of either that is deepest inside the other. Out of an open one that
/// is also through a hole.
struct MeshDepth {
  /// The corner and the point of the other surface nearest to it, as a contact; its normal is the
  /// local way out. Distance 0 where no corner of either is found inside the other, or a mesh has
  /// no inside.
  SignedDistance deepest;
  std::uint32_t points{0};  ///< measured
  std::uint32_t visits{0};  ///< nodes opened for them
  bool is_complete{false};  ///< no corner is deeper
};

/// The deepest corner of two meshes that move: that of the last query, measured anew, or a deeper
/// one. What the search passed over says how far meshes may move until it can be deeper, and is
/// looked at again then: in order of need, as many points as the budget and the step since the last
/// query allow. All begins anew after a step longer than the depth, or where nothing is kept.
///
/// Frames: world. Error: 1e-12 m for the corners looked at. Until the answer is complete there may
/// be deeper corners; once meshes stand it becomes complete. A pose that is not finite gives
/// distance 0, and leaves no trace. Limits: two solids may cross with no corner of one in the other
/// (crossed bars): the distance is then 0 and says nothing. The budget counts points whose distance
/// from the other mesh is searched for, and may be exceeded by three. The same queries give the
/// same answers. Source: signed distance changes by no more than the way gone, so a node whose
/// center is not deep enough for its size is passed over until the meshes have gone what it lacked:
/// Guthe, Borodin, Klein, "Fast and accurate Hausdorff distance calculation between meshes" (2005),
/// for such bounds; docs/decisions/mesh-depth.md.
/// @pre as distanceBetween. @param memory its content means nothing afterwards.
/// @param kept of the same meshes, or new. Changes the depth found, never that it is one.
MeshDepth depthOf(const PlacedMesh& a, const PlacedMesh& b, MeshQueryMemory& memory,
                  KeptDepth& kept, std::uint32_t point_budget) noexcept;

/// As new, for other places of the meshes.
void forget(KeptDepth& kept) noexcept;

}  // namespace collision_monitor
