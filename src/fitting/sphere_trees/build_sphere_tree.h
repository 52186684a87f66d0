// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "collision_monitor/fitting/overshoot.h"
#include "collision_monitor/geometry/geometry.h"
#include "collision_monitor/geometry/triangle_bvh.h"
#include "geometry/sphere_tree.h"

namespace collision_monitor {

/// When a sphere is small, tight or deep enough not to be divided further. The largest leaf is
/// divided first, so that a number of leaves is spent where it is needed.
struct SphereTreeLimits {
  std::size_t max_leaves{64};
  std::uint32_t max_level{30};  ///< of a leaf
  double min_radius{0.0};       ///< [m] spheres up to this one stay whole
  double min_overshoot{0.0};    ///< [m] spheres that overshoot no more stay whole
};

/// The sphere hierarchy of a geometry's surface, built top-down: the part of a node is cut across
/// the longest axis of its bounds, in the middle; triangles that the plane crosses are cut too, so
/// that no sphere has to hold what lies in its neighbour.
///
/// Frames: that of the geometry. Units: metres.
/// Error: every node's sphere encloses its part in exact arithmetic; its radius exceeds the least
/// one by about 1e-12 of it and 4e-15 of the largest coordinate a level. `overshoot` is the
/// largest of 32 samples, each up to 10 % too large; samples inside a closed surface count too.
/// Cylinders and capsules are replaced by polyhedra with 48 sides that hold them, up to 1 % wider.
/// Limits: flat meshes and single points are legal. A vertex of no triangle counts as a point of
/// the surface. A sphere is one node.
/// Source: Hubbard, "Collision Detection for Interactive Graphics Applications" (1995), and
/// Quinlan, "Efficient Distance Computation between Non-Convex Objects" (1994), for spheres that
/// each hold a part of the surface and the bounds this gives; Bradshaw, O'Sullivan, "Adaptive
/// Medial-Axis Approximation for Sphere-Tree Construction" (2004), for dividing one sphere at a
/// time. Departs from Quinlan in cutting triangles instead of covering them with small balls.
/// @throws std::invalid_argument with a sentence: no vertices, a vertex that is not finite or
/// beyond 1e100, a triangle without its vertices, a dimension that is negative or not finite, or a
/// `max_leaves` of 0.
SphereTree buildSphereTree(const Geometry& geometry, const SphereTreeLimits& limits);

}  // namespace collision_monitor
