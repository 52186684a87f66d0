// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/fitting/fit_parts.h"
#include "collision_monitor/geometry/triangle_bvh.h"
#include "collision_monitor/model/robot_model.h"

/// Models of links, ours and published ones, all measured by the same code: what they miss of a
/// link, and how far they stick out of it. Frames: those of the links. Units: metres.
namespace collision_monitor::test {

/// A box with half extents, or a cylinder around z of radius `rim` if `rim` is positive. Either is
/// inflated by `radius`.
struct Solid {
  Pose link_from_body;
  Eigen::Vector3d half_extents{Eigen::Vector3d::Zero()};
  double rim{0.0};
  double radius{0.0};
};

/// @throws std::invalid_argument for a mesh.
Solid toSolid(const Geometry& geometry, const Pose& link_from_body);

/// The shapes of all elements of a link.
std::vector<Solid> toSolids(const Link& link, const std::vector<Fit>& fits);

double signedDistance(const Solid& solid, const Eigen::Vector3d& point) noexcept;

/// About `count` points on a grid over the surface, edges and corners included, with the areas that
/// they represent.
std::vector<SurfaceSample> samplesOf(const Solid& solid, int count);

/// All meshes of a link as one. Other geometries are left out.
TriangleMesh meshOf(const Link& link);

/// The vertices, and a grid over every triangle: neighbours are a hundredth of the mesh's size
/// apart, and at least the middles of edges are included.
Points densePoints(const TriangleMesh& mesh);

/// How far the farthest point lies outside all solids; 0 if all are inside.
double missOf(const std::vector<Solid>& solids, const Points& points) noexcept;

/// How far the union sticks out of a surface. This is the package's definition with other samples
/// and another test of the inside, where the distance is 0: a winding number above one half
/// (Jacobson, Kavan, Sorkine-Hornung, "Robust Inside-Outside Segmentation using Generalized Winding
/// Numbers" (2013)).
/// Error: samples are up to sqrt(area of a solid / count) apart.
Overshoot overshootOf(const std::vector<Solid>& solids, const TriangleBvh& surface, int count);

/// As overshootOf by brute force: rays from each solid's center, every triangle for every point.
/// @return the maximum alone.
double bruteOvershoot(const std::vector<Solid>& solids, const TriangleBvh& surface, int rays);

}  // namespace collision_monitor::test
