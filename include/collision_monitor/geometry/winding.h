// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>

#include "collision_monitor/geometry/triangle.h"
#include "collision_monitor/geometry/triangle_mesh.h"

/// What winding numbers need: how often a surface goes around a point. Near a hole that is no whole
/// number. docs/decisions/inside-of-open-meshes.md says what is made of it.
namespace collision_monitor {

/// How much of all directions from a point triangles cover, summed. What a triangle covers is > 0
/// if the point is behind it; seen from the front, its corners turn left.
///
/// The half of a triangle's angle is that of a complex number, and a sum of angles that of a
/// product: so there is one arc tangent for all triangles. Units: [sr].
/// Error: 1e-15 times a few for each triangle of the size of 1 m; 1e-13 over the distance [m] from
/// its edges where that is small. Limits: of points in its plane, to rounding, the sign is any.
/// Source: van Oosterom, Strackee, "The Solid Angle of a Plane Triangle" (1983), for the number.
class SolidAngles {
 public:
  explicit SolidAngles(const Eigen::Vector3d& point) noexcept : point_(point) {}

  void add(const Triangle& triangle) noexcept;
  double sum() const noexcept;

 private:
  Eigen::Vector3d point_;
  double real_{1.0};       ///< of the product
  double imaginary_{0.0};  ///< never -0
  double turns_{0.0};      ///< whole ones that the angle of the product does not show
};

/// A part of a surface as points far from it see it.
struct WindingMoments {
  Eigen::Vector3d center{Eigen::Vector3d::Zero()};  ///< [m] of the area
  Eigen::Vector3d normal{Eigen::Vector3d::Zero()};  ///< [m^2] unit normals, summed over the area
  /// [m^3] way from the center times unit normal, summed over the area and made symmetric: xx, yy,
  /// zz, xy, yz, zx.
  std::array<double, 6> spread{};
  double area{0.0};     ///< [m^2]
  double squared{0.0};  ///< [m^4] squared way from the center, summed over the area
  double radius{0.0};   ///< [m] no point is farther from the center
};

WindingMoments momentsOf(const Triangle& triangle) noexcept;

/// Of both parts together; the radius, which grows more than need be, too.
WindingMoments joined(const WindingMoments& one, const WindingMoments& other) noexcept;

/// A number, and how far it may be off.
struct BoundedNumber {
  double value{0.0};
  double error{0.0};
};

/// What a part of a surface adds to the winding number of a point outside the ball about it.
///
/// Expands (y - x) / |y - x|^3 about the center, to first order. Error: 3 / (4 pi d^4) * squared,
/// with d the distance of the point from the ball, for no third derivative of 1 / r exceeds
/// 6 / r^4.
/// Source: Barill, Dickson, Schmidt, Levin, Jacobson, "Fast Winding Numbers for Soups and Clouds"
/// (2018), sections 3 and 4; the bound is ours.
BoundedNumber windingOf(const WindingMoments& part, const Eigen::Vector3d& point) noexcept;

/// The surface with triangles turned so that neighbours agree, and each connected part as most of
/// its area was. Of triangles with the same corners one counts; the others are three times their
/// first corner. Vertices, and which triangle is which, stay. Neighbours are two triangles that
/// share an edge by themselves; equal vertices are one.
TriangleMesh orientedSurface(const TriangleMesh& mesh);

/// Where a surface ends.
struct SurfaceRim {
  TriangleMesh edges;  ///< each a triangle (from, to, to)
  double length{0.0};  ///< [m] each edge as often as triangles end there
};

/// All edges but those that as many triangles go along as come back. Equal vertices are one.
SurfaceRim rimOf(const TriangleMesh& mesh);

}  // namespace collision_monitor
