// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "collision_monitor/geometry/ids.h"
#include "collision_monitor/geometry/mesh_tree.h"
#include "collision_monitor/geometry/pose.h"
#include "collision_monitor/geometry/shapes.h"
#include "collision_monitor/narrow_phase/convex_distance.h"
#include "collision_monitor/narrow_phase/signed_distance.h"
#include "narrow_phase/mesh_front/mesh_front.h"

/// Exact questions about meshes: do they overlap, how far are they apart, and where?
///
/// A mesh is its surface, and what is within if MeshTree::hasInside. Shapes are solid.
/// Frames: answers in the world frame. Units: metres.
/// Source: Larsen, Gottschalk, Lin, Manocha, "Fast Proximity Queries with Swept Sphere Volumes"
/// (1999), for branch and bound over pairs of nodes; Johnson, Cohen, "A framework for efficient
/// minimum distance computations" (1998), for starting from the last nearest pair.
/// @pre rotations are orthonormal up to rounding. A pose with an entry that is not finite is
/// legal: the answer is then MeshState::unknown.
namespace collision_monitor {

/// What an answer is worth.
enum class MeshState : unsigned char {
  exact,        ///< apart (or touching) by this distance, between these points
  lower_bound,  ///< at least this far apart: a limit or the budget was reached; points mean nothing
  overlapping,  ///< the distance is 0 or, for a shape's radius, a proven upper bound below it
  /// A pose is not finite, or 1e15 m off: nothing is known, and certainly not that they are apart.
  unknown,
};

/// Two triangles, by position in their trees. Survives from one query to the next.
struct TrianglePair {
  std::uint32_t a{kNone};
  std::uint32_t b{kNone};
};

struct MeshDistance {
  MeshState state{MeshState::unknown};
  SignedDistance measured;  ///< NaN-free in every state
  TrianglePair nearest;     ///< kNone where none was found; a start for the next query
  std::uint32_t visits{0};  ///< nodes opened; other work is converted
  double shortfall{0.0};    ///< [m] the nearest triangles are so much farther, within the tolerance
  /// [m] Where they are apart: how far one may go, seen from the other, until it can be inside an
  /// open mesh though it has not met its surface. Infinite for closed meshes.
  double outside{std::numeric_limits<double>::infinity()};
};

/// When a query may stop early. The defaults never do.
struct MeshQueryLimits {
  /// Farther apart is not measured: the answer is then lower_bound with this distance.
  double stop_beyond{std::numeric_limits<double>::infinity()};
  /// Visits after which nothing more is begun; the answer is then what is proven. Triangles are
  /// measured to the end, and those that were nearest before in any case.
  std::uint32_t visit_budget{std::numeric_limits<std::uint32_t>::max()};
  /// [m] 0 or more. What is found nearest may be farther than the nearest by that: the distance is
  /// then a proven lower bound that is short by no more, and so is the point on B moved.
  double tolerance{0.0};
};

/// What a query needs to remember on its way. One for each thread; its content means nothing
/// between queries. Large: keep it with the buffers of a cycle, not on a small stack.
struct MeshQueryMemory {
  /// Each opened node leaves seven others behind, on each level of both trees.
  static constexpr std::size_t kCapacity = 7 * 2 * (MeshTree::kMaxLevels + 1) + 8;

  struct NodePair {
    float squared_bound;
    std::uint32_t a;
    std::uint32_t b;
  };
  std::array<NodePair, kCapacity + MeshFront::kCapacity> node_pairs;
};

/// A mesh and where it is.
struct PlacedMesh {
  const MeshTree& tree;
  const Pose& world_from_mesh;
};

/// A shape of the core + radius family and where it is.
struct PlacedShape {
  const Shape& shape;
  const Pose& world_from_shape;
};

/// A convex geometry and where it is.
struct PlacedConvex {
  const ConvexGeometry& geometry;
  const Pose& world_from_body;
};

/// What a search for contact found of two meshes.
struct MeshContact {
  enum class State : unsigned char {
    apart,
    contact,
    open,  ///< the budget ended the search, or a pose is not finite
  };
  State state{State::open};
  TrianglePair triangles;   ///< that are in contact; a start for the next query
  std::uint32_t visits{0};  ///< nodes opened and triangles looked at
  double outside{std::numeric_limits<double>::infinity()};  ///< [m] as MeshDistance::outside
};

/// What is asked about contact. The defaults: whether the meshes overlap, whatever it takes.
struct MeshContactQuery {
  double distance{0.0};      ///< [m] surfaces that near are in contact; 0 or more, finite
  bool asks_outside{false};  ///< MeshContact::outside is wanted, too
  std::uint32_t visit_budget{std::numeric_limits<std::uint32_t>::max()};  ///< as MeshQueryLimits
};

/// Whether surfaces come within a distance of each other, or one mesh that has an inside holds a
/// point of the other. Ends at the first contact, and measures nothing.
///
/// Error: surfaces within 1e-14 of the size may be called either way; of a distance above 0 as
/// distanceBetween. Each connected piece of a mesh is asked for being inside the other; where that
/// is open, also the corners that are farthest in fourteen directions.
/// @param start triangles that were in contact before, which are asked first. It changes the time
/// and which contact is found; never whether there is one.
MeshContact contactOf(const PlacedMesh& a, const PlacedMesh& b, const MeshContactQuery& query,
                      MeshQueryMemory& memory, const TrianglePair& start = TrianglePair{}) noexcept;

/// The same of a mesh and a solid. @param start of which `a` counts.
MeshContact contactOf(const PlacedMesh& a, const PlacedConvex& b, const MeshContactQuery& query,
                      MeshQueryMemory& memory, const TrianglePair& start = TrianglePair{}) noexcept;

/// Distance of two meshes, 0 when they overlap (see mesh_depth.h and mesh_way_out.h).
///
/// Error: for meshes up to 10 m, the distance is exact to 1e-9 m for triangles however thin and
/// to some ulps for others; both points are on the surfaces.
/// Limits: meshes nearer than 1e-14 of their size are overlapping.
/// @param start the nearest pair of an earlier query of the same meshes, or none. It changes the
/// time and, of points equally near, which are found; never the distance.
MeshDistance distanceBetween(const PlacedMesh& a, const PlacedMesh& b, MeshQueryMemory& memory,
                             const TrianglePair& start = TrianglePair{},
                             const MeshQueryLimits& limits = MeshQueryLimits{}) noexcept;

/// The same from what the last query about the same two meshes left: where they have moved little,
/// in a fraction of the time.
/// @param front changes the time and, of points equally near, which are found; never the distance,
/// but for rounding. A search that the budget ended goes on from there. Whether a mesh has got
/// inside an open one is not asked again for ways of a thousandth of the open one's radius.
MeshDistance distanceBetween(const PlacedMesh& a, const PlacedMesh& b, MeshQueryMemory& memory,
                             MeshFront& front,
                             const MeshQueryLimits& limits = MeshQueryLimits{}) noexcept;

/// Signed distance of a mesh (A) and a solid shape (B).
///
/// Sign: > 0 apart. < 0 overlapping: a bound, for no shorter way than its length takes the shape
/// off the nearest point of the surface, or out of the mesh. If the core itself meets the surface,
/// the bound is minus the radius. Error: of distances > 0 as for two meshes. Limits: a core inside
/// a mesh is seen when the surface does not cross it; one that reaches into an open mesh through a
/// hole, by its corners and its nearest point.
/// @param start of which `a` counts.
MeshDistance distanceBetween(const PlacedMesh& a, const PlacedShape& b, MeshQueryMemory& memory,
                             const TrianglePair& start = TrianglePair{},
                             const MeshQueryLimits& limits = MeshQueryLimits{}) noexcept;

/// The same for any convex geometry. Error: 1e-9 m with cylinders and hulls.
///
/// Of a half space the distance is exact in either sign, at the corner that is lowest, and no limit
/// applies. A hull costs a search for each triangle near it: a mesh of its surface has less to do
/// where it has many corners. @param front as of two meshes.
MeshDistance distanceBetween(const PlacedMesh& a, const PlacedConvex& b, MeshQueryMemory& memory,
                             const TrianglePair& start = TrianglePair{},
                             const MeshQueryLimits& limits = MeshQueryLimits{}) noexcept;
MeshDistance distanceBetween(const PlacedMesh& a, const PlacedConvex& b, MeshQueryMemory& memory,
                             MeshFront& front,
                             const MeshQueryLimits& limits = MeshQueryLimits{}) noexcept;

}  // namespace collision_monitor
