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

/// Exact queries about meshes: do they overlap, how far apart are they, and where?
///
/// A mesh is its surface, and also its inside if MeshTree::hasInside. Shapes are solid.
/// Frames: answers are in the world frame. Units: metres.
/// Source: Larsen, Gottschalk, Lin, Manocha, "Fast Proximity Queries with Swept Sphere Volumes"
/// (1999), for branch and bound over pairs of nodes; Johnson, Cohen, "A framework for efficient
/// minimum distance computations" (1998), for starting from the last nearest pair.
/// @pre rotations are orthonormal up to rounding. A pose that is not finite is legal: the answer is
/// then MeshState::unknown.
namespace collision_monitor {

/// What an answer proves.
enum class MeshState : unsigned char {
  exact,        ///< apart (or touching) by this distance, between these points
  lower_bound,  ///< at least this far apart: a limit or the budget ended it; points mean nothing
  overlapping,  ///< the distance is 0 or, with a solid shape, a proven upper bound below 0
  /// A pose is not finite, or 1e15 m away: nothing is proven, not even that they are apart.
  unknown,
};

/// Two triangles, by index in their trees. Kept from one query to the next.
struct TrianglePair {
  std::uint32_t a{kNone};
  std::uint32_t b{kNone};
};

/// Names a probe: a point of one of two meshes, for which the other is asked whether it holds it.
/// Numbers first the probes of B, then those of A.
using HeldProbe = std::uint32_t;

/// How many probes two meshes have.
std::size_t countProbes(const MeshTree& a, const MeshTree& b) noexcept;

struct MeshDistance {
  MeshState state{MeshState::unknown};
  SignedDistance measured;  ///< NaN-free in every state
  TrianglePair nearest;     ///< kNone if none was found; a start for the next query
  std::uint32_t visits{0};  ///< nodes opened; other work is converted to nodes
  double shortfall{0.0};    ///< [m] how much less the distance is than that of the points found
  /// [m] If apart: a mesh must travel at least this far, seen from the other, before one can be
  /// inside of the other without having met its surface. Infinite if both are closed.
  double outside{std::numeric_limits<double>::infinity()};
  HeldProbe held{kNone};  ///< the probe that proves the overlap; none if triangles do
};

/// Limits at which a query may stop early. The defaults have no effect.
struct MeshQueryLimits {
  /// [m] Greater distances are not measured: the answer is then lower_bound with this distance.
  double stop_beyond{std::numeric_limits<double>::infinity()};
  /// Visits after which no new work starts. The answer is then what is proven. Triangles are
  /// measured to the end, and the last nearest ones in any case.
  std::uint32_t visit_budget{std::numeric_limits<std::uint32_t>::max()};
  /// [m] 0 or more. The triangles found may be farther than the nearest by this. The distance is
  /// then a proven lower bound that is short by no more, and the point on B is moved to fit.
  double tolerance{0.0};
  bool asks_outside{true};  ///< MeshDistance::outside is wanted, too
  /// [m] What is known before: the convex hulls of both are this far apart. So the surfaces are no
  /// nearer, and neither mesh holds a point of the other. 0: nothing is known.
  double at_least{0.0};
  HeldProbe held{kNone};  ///< the probe that was held before; it is asked first
};

/// Scratch of a query; one per thread. Its content means nothing between queries. It is large: keep
/// it with the buffers of a cycle, not on a small stack.
struct MeshQueryMemory {
  /// Each opened node leaves seven others on each level of both trees.
  static constexpr std::size_t kCapacity = 7 * 2 * (MeshTree::kMaxLevels + 1) + 8;

  struct NodePair {
    float squared_bound;
    std::uint32_t a;
    std::uint32_t b;
  };
  std::array<NodePair, kCapacity + MeshFront::kCapacity> node_pairs;
};

/// A mesh and its pose.
struct PlacedMesh {
  const MeshTree& tree;
  const Pose& world_from_mesh;
};

/// A shape of the core + radius family and its pose.
struct PlacedShape {
  const Shape& shape;
  const Pose& world_from_shape;
};

/// A convex geometry and its pose.
struct PlacedConvex {
  const ConvexGeometry& geometry;
  const Pose& world_from_body;
};

/// The answer to a query for contact.
struct MeshContact {
  enum class State : unsigned char {
    apart,
    contact,
    open,  ///< the budget ended the search, or a pose is not finite
  };
  State state{State::open};
  TrianglePair triangles;   ///< in contact; a start for the next query
  std::uint32_t visits{0};  ///< nodes opened and triangles looked at
  double outside{std::numeric_limits<double>::infinity()};  ///< [m] as MeshDistance::outside
  HeldProbe held{kNone};                                    ///< as MeshDistance
};

/// A query for contact. The defaults ask whether the meshes overlap, whatever it takes.
struct MeshContactQuery {
  double distance{0.0};      ///< [m] surfaces this near are in contact; 0 or more, finite
  bool asks_outside{false};  ///< MeshContact::outside is wanted too
  /// [m] Above 0: it is known before that neither mesh holds a point of the other. The value
  /// becomes MeshContact::outside.
  double outside{0.0};
  std::uint32_t visit_budget{std::numeric_limits<std::uint32_t>::max()};  ///< as MeshQueryLimits
  HeldProbe held{kNone};                                                  ///< as MeshQueryLimits
  KeptProbes probes{};  ///< of earlier queries of the same meshes, and for later ones
};

/// Finds whether surfaces come within a distance of each other, or one mesh that has an inside
/// holds a point of the other. Ends at the first contact and measures nothing.
///
/// Error: surfaces within 1e-14 of the size may count either way; for a distance above 0, as
/// distanceBetween. Each connected piece of a mesh is tested for being inside the other. For an
/// open one, so are the corners that are farthest in fourteen directions.
/// @param start triangles that were in contact before. They are tested first and change the time
/// and which contact is found, never whether there is one.
MeshContact contactOf(const PlacedMesh& a, const PlacedMesh& b, const MeshContactQuery& query,
                      MeshQueryMemory& memory, const TrianglePair& start = TrianglePair{}) noexcept;

/// The same for a mesh and a solid. @param start only `a` counts.
MeshContact contactOf(const PlacedMesh& a, const PlacedConvex& b, const MeshContactQuery& query,
                      MeshQueryMemory& memory, const TrianglePair& start = TrianglePair{}) noexcept;

/// Measures two meshes. Their distance is 0 if they overlap (see mesh_depth.h and mesh_way_out.h).
///
/// Error: for meshes up to 10 m, 1e-9 m for triangles however thin and a few ulps for others. Both
/// points are on the surfaces.
/// Limits: meshes nearer than 1e-14 of their size overlap.
/// @param start the nearest pair of an earlier query of the same meshes, or none. It changes the
/// time and which of equally near points are found, never the distance.
MeshDistance distanceBetween(const PlacedMesh& a, const PlacedMesh& b, MeshQueryMemory& memory,
                             const TrianglePair& start = TrianglePair{},
                             const MeshQueryLimits& limits = MeshQueryLimits{}) noexcept;

/// The same from the front that the last query of the same two meshes left. Takes a fraction of the
/// time if they moved little.
/// @param front changes the time, which of equally near points are found, and the rounding of the
/// distance. A search that the budget ended continues from it. Whether a mesh is inside an open one
/// is asked again only after travel of a thousandth of the open one's radius.
MeshDistance distanceBetween(const PlacedMesh& a, const PlacedMesh& b, MeshQueryMemory& memory,
                             MeshFront& front,
                             const MeshQueryLimits& limits = MeshQueryLimits{}) noexcept;

/// Signed distance of a mesh (A) and a solid shape (B).
///
/// Sign: > 0 apart. < 0 overlapping: a bound. No shorter translation takes the shape off the
/// nearest point of the surface, or out of the mesh. If the core itself meets the surface, the
/// bound is minus the radius. Error: of distances > 0, as for two meshes. Limits: a core inside a
/// mesh is found if the surface does not cross it; one that enters an open mesh through a hole, by
/// its corners and its nearest point.
/// @param start only `a` counts.
MeshDistance distanceBetween(const PlacedMesh& a, const PlacedShape& b, MeshQueryMemory& memory,
                             const TrianglePair& start = TrianglePair{},
                             const MeshQueryLimits& limits = MeshQueryLimits{}) noexcept;

/// The same for any convex geometry. Error: 1e-9 m with cylinders and hulls.
///
/// A half space has an exact distance of either sign, at the lowest corner, and no limit applies. A
/// hull costs a search for each triangle near it: if it has many corners, a mesh of its surface is
/// faster. @param front as for two meshes.
MeshDistance distanceBetween(const PlacedMesh& a, const PlacedConvex& b, MeshQueryMemory& memory,
                             const TrianglePair& start = TrianglePair{},
                             const MeshQueryLimits& limits = MeshQueryLimits{}) noexcept;
MeshDistance distanceBetween(const PlacedMesh& a, const PlacedConvex& b, MeshQueryMemory& memory,
                             MeshFront& front,
                             const MeshQueryLimits& limits = MeshQueryLimits{}) noexcept;

}  // namespace collision_monitor
