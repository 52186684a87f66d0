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

/// Signed distance of any two convex geometries: what a URDF or a scene names, not only the shapes
/// that enclose it. See signed_distance.h for frames and sign.
namespace collision_monitor {

/// The closed set of convex geometries: every pair of them has an answer.
using ConvexGeometry =
    std::variant<Sphere, Capsule, Box, RoundedBox, Cylinder, ConvexHull, HalfSpace>;

struct ConvexDistance {
  SignedDistance measured;
  Quality quality{Quality::unknown};
};

/// What a search may use and what it leaves for the next one.
struct ConvexSearch {
  ConvexWorkspace& workspace;  ///< scratch; one a thread
  ConvexWarmStart& warm;       ///< of this pair; an empty one is always right
  /// [m] pairs proven to be farther apart than this need not be measured: the answer is then a
  /// lower bound not below it.
  double cutoff{std::numeric_limits<double>::infinity()};
};

/// The least distance of A and B, or the length of the least translation that separates them.
///
/// Sphere, capsule, box and rounded box among themselves are measured by their closed forms (see
/// distance.h), two boxes only where their last answer is not proven to hold still; a half space by
/// the support function of the other; points and parallel axes with a cylinder by theirs;
/// everything else by GJK, and EPA where the cores overlap, or, of hulls with few faces that are
/// met for the first time, by their separating axes.
///
/// Error: 1e-9 m apart, 1e-7 m in depth for lengths from 1 mm to 10 m and distances up to 10 m;
/// docs/accuracy.md has what was measured. An answer that iteration could not settle says
/// `lower_bound` and is one.
/// Limits: zero-size, flat, touching, concentric and parallel geometries are legal. Where the
/// normal is not unique, one is chosen that realises the distance. Where faces or edges are
/// parallel, the points lie over the middle of what they share.
/// Source: Gilbert, Johnson, Keerthi, "A fast procedure for computing the distance between
/// complex objects in three-dimensional space" (1988); van den Bergen, "Collision Detection in
/// Interactive 3D Environments" (2003), chapter 4. Departures are named in src/narrow_phase.
/// @pre poses are rigid if they are finite.
ConvexDistance signedDistanceBetween(const ConvexGeometry& a, const Pose& world_from_a,
                                     const ConvexGeometry& b, const Pose& world_from_b,
                                     ConvexSearch& search) noexcept;

}  // namespace collision_monitor
