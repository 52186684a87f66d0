// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "collision_monitor/fitting/overshoot.h"
#include "collision_monitor/geometry/geometry.h"
#include "collision_monitor/geometry/triangle_bvh.h"
#include "geometry/sphere_tree.h"

namespace collision_monitor {

/// When a sphere is small, tight or deep enough to stay whole. The largest leaf is divided first,
/// so leaves go where they are needed.
struct SphereTreeLimits {
  std::size_t max_leaves{64};
  std::uint32_t max_level{30};  ///< of a leaf
  double min_radius{0.0};       ///< [m] spheres up to this one stay whole
  double min_overshoot{0.0};    ///< [m] spheres that overshoot no more stay whole
};

/// The sphere hierarchy of a geometry's surface, built top-down. The part of a node is cut in the
/// middle, across the longest axis of its bounds. Triangles that the plane crosses are cut too, so
/// no sphere has to hold its neighbour's part.
/// [m] spheres up to this radius stay whole
/// [m] spheres with at most this overshoot stay whole
/// Error: every node's sphere encloses its part in exact arithmetic. Its radius exceeds the least
/// one by about 1e-12 of it, and by 4e-15 of the largest coordinate per level. `overshoot` is the
/// largest of 32 samples, each up to 10 % too large; samples inside a closed surface count too.
/// Cylinders and capsules are replaced by polyhedra around them with 48 sides, up to 1 % wider.
/// Limits: flat meshes and single points are legal. A vertex of no triangle counts as a point of
/// the surface. A sphere is one node.
/// Source: spheres that each hold a part of the surface, and their bounds: Hubbard, "Collision
/// Detection for Interactive Graphics Applications" (1995), and Quinlan, "Efficient Distance
/// Computation between Non-Convex Objects" (1994); dividing one sphere at a time: Bradshaw,
/// O'Sullivan, "Adaptive Medial-Axis Approximation for Sphere-Tree Construction" (2004). Departs
/// from Quinlan: cuts triangles and does not cover them with small balls.
/// @throws std::invalid_argument with a sentence: no vertices, a vertex that is not finite or
/// beyond 1e100, a triangle with a missing vertex, a dimension that is negative or not finite, or a
/// `max_leaves` of 0.
SphereTree buildSphereTree(const Geometry& geometry, const SphereTreeLimits& limits);

}  // namespace collision_monitor
