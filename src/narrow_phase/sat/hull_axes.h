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

  /// [m] > 0: the hulls are apart, by this at least. Otherwise minus the penetration depth.
  double separation{-std::numeric_limits<double>::infinity()};
  Eigen::Vector3d direction{Eigen::Vector3d::UnitX()};  ///< unit, from A to B, world frame
  Kind kind{Kind::face_of_a};
  std::uint32_t feature_of_a{0};  ///< the face or edge of A; of a face of B: A's nearest vertex
  std::uint32_t feature_of_b{0};  ///< likewise
};

/// The separating axis test of two convex polyhedra: face normals of both, and cross products of
/// those edges whose sum is an edge of the Minkowski difference, which their arcs on the Gauss map
/// tell. The test of two boxes is the special case in which fifteen axes do.
///
/// Of the pairs of edges only few are looked at: those that no point of the other hull, known from
/// the faces, shows to separate less than the best face. It settles depths that an iteration might
/// not; signedDistanceBetween begins with it where hulls with few faces are met for the first time.
/// Error: some ulps of the lengths. Edges whose sine is below 1e-12 count as parallel: what lies
/// between them is a sliver so thin that the faces beside it say the same.
/// Source: Gregorius, "The Separating Axis Test between Convex Polyhedra" (Game Developers
/// Conference 2013), for the Gauss map; Gottschalk, Lin, Manocha, "OBBTree" (1996). Departs from
/// them in what is passed over.
/// @pre both hulls have volume and edges; poses are finite and rigid.
HullAxis separateHulls(const ConvexHull& a, const Pose& world_from_a, const ConvexHull& b,
                       const Pose& world_from_b) noexcept;

}  // namespace collision_monitor
