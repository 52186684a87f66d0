// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>
#include <variant>

#include "collision_monitor/geometry/half_space.h"
#include "collision_monitor/geometry/hull.h"
#include "collision_monitor/geometry/pose.h"
#include "collision_monitor/geometry/shapes.h"
#include "collision_monitor/narrow_phase/convex_workspace.h"
#include "collision_monitor/narrow_phase/quality.h"
#include "collision_monitor/narrow_phase/signed_distance.h"

/// Signed distance of any two convex geometries: what a URDF or a scene names, and the shapes that
/// enclose it. See signed_distance.h for frames and sign.
namespace collision_monitor {

/// The closed set of convex geometries. Every pair of them has an answer.
using ConvexGeometry =
    std::variant<Sphere, Capsule, Box, RoundedBox, Cylinder, ConvexHull, HalfSpace>;

/// The answer for two convex geometries.
struct ConvexDistance {
  SignedDistance measured;            ///< distance, points and normal
  Quality quality{Quality::unknown};  ///< what the distance is worth
};

/// What a search may use, and what it leaves for the next search of the pair.
struct ConvexSearch {
  ConvexWorkspace& workspace;  ///< scratch; one per thread
  ConvexWarmStart& warm;       ///< of this pair; an empty one is always valid
  /// [m] A search may stop once it proves a greater distance. The answer is then a lower bound that
  /// is at least the cutoff.
  double cutoff{std::numeric_limits<double>::infinity()};
  /// The question stands alone: the pair did not move here from the poses of its last search, and
  /// only the distance matters. A cylinder's search then starts anew, and ends at a depth within
  /// 5e-8 m. The points need not be the middle of those that are equally near.
  bool stands_alone{false};
};

/// Measures the distance of A and B. If they overlap, it is minus their penetration depth.
///
/// Spheres, capsules, boxes and rounded boxes have closed forms (see distance.h). Two boxes use
/// theirs only if their last answer cannot be proven to hold. A half space uses the support
/// function of the other geometry. A cylinder has closed forms with a point and with a parallel
/// axis. Two hulls with few faces and no warm start use separating axes. GJK measures everything
/// else, and EPA the overlaps.
///
/// Error: 1e-9 m apart and 1e-7 m in depth, for lengths from 1 mm to 10 m and distances up to 10 m;
/// docs/accuracy.md has the measured errors. An answer that iteration could not settle is a
/// `lower_bound`.
/// Limits: zero-size, flat, touching, concentric and parallel geometries are legal. If the normal
/// is not unique, it is one that realises the distance. If faces or edges are parallel, the points
/// lie over the middle of their common part.
/// Source: Gilbert, Johnson, Keerthi, "A fast procedure for computing the distance between
/// complex objects in three-dimensional space" (1988); van den Bergen, "Collision Detection in
/// Interactive 3D Environments" (2003), chapter 4. Departures are named in src/narrow_phase.
/// @pre poses are rigid if they are finite.
ConvexDistance signedDistanceBetween(const ConvexGeometry& a, const Pose& world_from_a,
                                     const ConvexGeometry& b, const Pose& world_from_b,
                                     ConvexSearch& search) noexcept;

}  // namespace collision_monitor
