// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/fitting/fit_parts.h"
#include "collision_monitor/geometry/triangle_bvh.h"
#include "collision_monitor/model/robot_model.h"

/// Models of links, ours and published ones, measured by one and the same code: what of a link they
/// miss, and how far they stick out of it. Frames: those of the links. Units: metres.
namespace collision_monitor::test {

/// A box with half extents, or where `rim` is positive a cylinder around z of that radius; either
/// with all points within `radius` of it.
struct Solid {
  Pose link_from_body;
  Eigen::Vector3d half_extents{Eigen::Vector3d::Zero()};
  double rim{0.0};
  double radius{0.0};
};

/// @throws std::invalid_argument for a mesh.
Solid toSolid(const Geometry& geometry, const Pose& link_from_body);

/// The shapes of a link's elements together.
std::vector<Solid> toSolids(const Link& link, const std::vector<Fit>& fits);

double signedDistance(const Solid& solid, const Eigen::Vector3d& point) noexcept;

/// Points on a grid over the surface, edges and corners included, and the areas that they stand
/// for; about `count`.
std::vector<SurfaceSample> samplesOf(const Solid& solid, int count);

/// All meshes of a link as one. Elements of other kinds are left out.
TriangleMesh meshOf(const Link& link);

/// The vertices, and a grid over every triangle with a hundredth of the mesh's size between
/// neighbours and no fewer than its middles of edges.
Points densePoints(const TriangleMesh& mesh);

/// How far the farthest point lies outside all solids; 0 when all are inside.
double missOf(const std::vector<Solid>& solids, const Points& points) noexcept;

/// How far the union sticks out of a surface: the package's definition with another sampling and
/// another test for what is inside, where the distance is 0: a winding number beyond a half
/// (Jacobson, Kavan, Sorkine-Hornung, "Robust Inside-Outside Segmentation using Generalized Winding
/// Numbers" (2013)).
/// Error: points up to sqrt(area of a solid / count) apart.
Overshoot overshootOf(const std::vector<Solid>& solids, const TriangleBvh& surface, int count);

/// The same by brute force: rays from the middle of each solid, every triangle for every point.
/// @return the maximum alone.
double bruteOvershoot(const std::vector<Solid>& solids, const TriangleBvh& surface, int rays);

}  // namespace collision_monitor::test
