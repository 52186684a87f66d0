// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>

#include "collision_monitor/geometry/hull.h"
#include "collision_monitor/geometry/pose.h"

namespace collision_monitor {

/// The axis along which two convex polyhedra are separated most.
struct HullAxis {
  enum class Kind : unsigned char { face_of_a, face_of_b, edges };

  /// [m] > 0: the hulls are apart by at least this. Otherwise minus the penetration depth.
  double separation{-std::numeric_limits<double>::infinity()};
  Eigen::Vector3d direction{Eigen::Vector3d::UnitX()};  ///< unit, from A to B, in A's frame
  Kind kind{Kind::face_of_a};
  std::uint32_t feature_of_a{0};  ///< the face or edge of A; if face_of_b, A's nearest vertex
  std::uint32_t feature_of_b{0};  ///< likewise
};

/// The separating axis test of two convex polyhedra. The axes are the face normals of both, and the
/// cross products of edges that make a face of the Minkowski difference: their arcs on the Gauss
/// map cross. For two boxes fifteen axes suffice.
///
/// Looks at few pairs of edges. Skips an edge if a known point of the other hull shows that it
/// separates less than the best face. Settles depths that an iteration might not.
/// signedDistanceBetween starts with it for hulls with few faces and no warm start.
/// Error: a few ulps of the lengths. Edges with a sine below 1e-12 count as parallel: the sliver
/// between them is so thin that the faces beside it give the same.
/// Source: Gregorius, "The Separating Axis Test between Convex Polyhedra" (Game Developers
/// Conference 2013), for the Gauss map; Gottschalk, Lin, Manocha, "OBBTree" (1996). Departure: what
/// is skipped.
/// @param cutoff [m] a face that separates this much ends the search.
/// @pre both hulls have volume and edges; the pose is finite and rigid.
HullAxis bestAxis(const ConvexHull& a, const ConvexHull& b, const Pose& a_from_b,
                  double cutoff = std::numeric_limits<double>::infinity()) noexcept;

}  // namespace collision_monitor
