// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include "collision_monitor/narrow_phase/mesh_distance.h"

namespace collision_monitor {

/// How deep two meshes are in each other, between two proven bounds.
///
/// The depth is the length of the least translation that separates the solids. For meshes that are
/// not convex nobody computes it in a cycle; what is offered are the point of either surface that
/// is deepest inside the other solid, which every separating translation has to bring out, and the
/// best of several directions in which one mesh can be pulled off the other entirely.
struct MeshPenetration {
  /// [m] No shorter translation separates the solids. 0 when no corner of either is found inside
  /// the other, or a mesh has no inside.
  double at_least{0.0};
  /// [m] Moving B by this along `way_out` separates them; may be far more than needed where one
  /// hooks into the other. At most 0 when they are separated.
  double at_most{std::numeric_limits<double>::infinity()};
  Eigen::Vector3d way_out{Eigen::Vector3d::UnitX()};
  /// The deepest corner found and the point of the other surface nearest to it: distance is
  /// -at_least. An estimate of the contact as SignedDistance would give it; its normal is the
  /// local way out.
  SignedDistance deepest;
  bool is_complete{false};  ///< false: the budget ended the search, or a pose is not finite
};

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

/// The deepest corner found, as MeshPenetration::deepest.
struct MeshDepth {
  SignedDistance deepest;
  std::uint32_t points{0};  ///< measured
  bool is_complete{false};  ///< as in MeshPenetration
};

/// The deepest corner of two meshes that move: that of the last query, measured anew, or a deeper
/// one. The search for deeper ones goes on where it stopped, the further the more of the depth they
/// have moved by since the last query, and begins anew after a step longer than that.
///
/// Frames: world. Error: as penetrationOf. While meshes move there may be deeper corners than those
/// looked at, by twice the way since they last were at most; once they stand the answer becomes
/// complete. Limits: the budget may be exceeded by three points. The same queries give the same
/// answers.
/// Source: docs/decisions/mesh-depth.md.
/// @param kept of the same meshes, or new. Changes the depth found, never that it is one.
MeshDepth depthOf(const PlacedMesh& a, const PlacedMesh& b, MeshQueryMemory& memory,
                  KeptDepth& kept, std::uint32_t point_budget) noexcept;

/// As new, for other places of the meshes.
void forget(KeptDepth& kept) noexcept;

/// Frames: world. Units: metres.
/// Error: `at_least` exact to 1e-12 m for the corners looked at; when complete it is the largest
/// over all corners of both meshes. `at_most` to 1e-12 m.
/// Limits: two solids may cross with no corner of one in the other (crossed bars): `at_least` is
/// then 0 and says nothing. The budget counts points whose distance from the other mesh is searched
/// for, half of them for either mesh; a few more may be.
/// Source: signed distance changes by no more than the way gone, so a node whose centre is not deep
/// enough for its size is passed over: Guthe, Borodin, Klein, "Fast and accurate Hausdorff distance
/// calculation between meshes" (2005), for such bounds.
/// @pre as distanceBetween. @param memory its content means nothing afterwards.
MeshPenetration penetrationOf(const PlacedMesh& a, const PlacedMesh& b, MeshQueryMemory& memory,
                              std::uint32_t point_budget = 100) noexcept;

}  // namespace collision_monitor
