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
  /// [m] of a support plane, so the cores are at most this deep. Negative: they are apart.
  double depth{std::numeric_limits<double>::infinity()};
  double at_least{0.0};  ///< [m] of the polytope, when the search ended before it was settled
  /// Unit, in A's frame: moving B against it by the depth separates the cores.
  Eigen::Vector3d outward{Eigen::Vector3d::UnitX()};
  Eigen::Vector3d on_a{Eigen::Vector3d::Zero()};  ///< in A's frame
  Eigen::Vector3d on_b{Eigen::Vector3d::Zero()};  ///< in B's frame
  bool is_settled{false};                         ///< no face of the polytope says less
  /// Corners of the face where the points are: where the next search may start. None when flat.
  std::array<SupportVertex, 3> face;
  int face_size{0};
};

/// Grows a polytope inside the difference from the simplex that holds or touches the origin, until
/// the face nearest to the origin is one of the difference's own.
///
/// The depth reported is always one that a support plane proves; the polytope, which is inside,
/// says how much less it could be. A face that rounding keeps from being refined answers with
/// its support plane.
/// Error: settled means that both differ by 1e-10 of the pair's size at most with a cylinder, by
/// rounding otherwise.
/// Limits: a difference without volume (crossing segments, coplanar polygons) has depth 0.
/// Source: van den Bergen, "Proximity Queries and Penetration Depth Computation on 3D Game
/// Objects" (2001). Departs from it in the outline, which is checked before anything changes.
Penetration runEpa(ConvexPair& pair, const Simplex& simplex, ConvexWorkspace& polytope) noexcept;

}  // namespace collision_monitor
