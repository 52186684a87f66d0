// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <limits>

#include "narrow_phase/gjk/convex_pair.h"
#include "narrow_phase/gjk/simplex.h"

namespace collision_monitor {

/// How deep two cores overlap.
struct Penetration {
  /// [m] Of a support plane: the cores are at most this deep. Negative: they are apart.
  double depth{std::numeric_limits<double>::infinity()};
  double at_least{0.0};  ///< [m] proven by the polytope, if the search ended unsettled
  /// Unit, in A's frame. Moving B against it by the depth separates the cores.
  Eigen::Vector3d outward{Eigen::Vector3d::UnitX()};
  Eigen::Vector3d on_a{Eigen::Vector3d::Zero()};  ///< in A's frame
  Eigen::Vector3d on_b{Eigen::Vector3d::Zero()};  ///< in B's frame
  bool is_settled{false};                         ///< no face of the polytope is less deep
  /// Corners of the face that holds the points: a start for the next search. None if flat.
  std::array<SupportVertex, 3> face;
  int face_size{0};
};

/// Grows a polytope inside the Minkowski difference, from the simplex that holds or touches the
/// origin, until the face nearest to the origin is a face of the difference.
///
/// The depth is always proven by a support plane. The polytope lies inside and bounds it from
/// below. If rounding keeps a face from being refined, its support plane is the answer.
/// Error: if settled, both bounds differ by at most the tolerance.
/// Limits: a difference without volume (crossing segments, coplanar polygons) has depth 0.
/// Source: van den Bergen, "Proximity Queries and Penetration Depth Computation on 3D Game Objects"
/// (2001). Departure: the outline is checked before anything changes.
/// @param tolerance [m] at least roundingOf(pair)
Penetration runEpa(ConvexPair& pair, const Simplex& simplex, double tolerance,
                   ConvexWorkspace& polytope) noexcept;

}  // namespace collision_monitor
