// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "collision_monitor/geometry/triangle.h"
#include "collision_monitor/geometry/triangle_mesh.h"

/// Winding numbers: how often a surface goes around a point. Near a hole they are not whole.
/// docs/decisions/inside-of-open-meshes.md says how they are used.
namespace collision_monitor {

/// Sums the solid angles of triangles seen from a point. A triangle's angle is > 0 if the point is
/// behind it. Seen from its front, a triangle's corners turn left.
///
/// Half the angle of a triangle is the argument of a complex number. A sum of angles is the
/// argument of a product, so one arc tangent serves all triangles. Triangles wait until there are
/// enough for all lanes of a vector. Units: [sr].
/// Error: a few times 1e-15 for each triangle of the size of 1 m; 1e-13 over the distance [m] from
/// its edges where that is small. Of slivers, whose corners are in line but for the share h, it
/// grows by 1 / h^2. Limits: points in a triangle's plane get either sign.
/// Source: van Oosterom, Strackee, "The Solid Angle of a Plane Triangle" (1983).
class SolidAngles {
 public:
  /// @param point [m] from where the triangles are seen
  explicit SolidAngles(const Eigen::Vector3d& point) noexcept;

  void add(const Triangle& triangle) noexcept;  ///< adds a triangle's angle
  double sum() noexcept;  ///< [sr] the sum so far: 4 pi inside a closed surface, 0 outside

  static constexpr std::size_t kLanes = 8;  ///< products, with every instruction set

  /// Products of complex numbers, one per lane. The same bytes with every instruction set.
  struct Products {
    alignas(64) std::array<double, kLanes> real{1, 1, 1, 1, 1, 1, 1, 1};  ///< up to a factor
    alignas(64) std::array<double, kLanes> imaginary{};                   ///< never -0
    alignas(64) std::array<double, kLanes> turns{};  ///< whole turns that arguments do not show

    double angle() const noexcept;  ///< [sr] twice the argument of the product of all
  };
  /// Triangles not yet multiplied, in columns: coordinates of the corners, seen from the point.
  struct Batch {
    static constexpr std::size_t kMost = 4 * kLanes;               ///< how many triangles it holds
    alignas(64) std::array<std::array<double, kMost>, 9> columns;  ///< [m] by number and triangle
    std::size_t count{0};                                          ///< how many it has
  };

 private:
  void multiplyBatch() noexcept;

  Eigen::Vector3d point_;
  Products products_;
  Batch batch_;
};

/// Moments of a part of a surface, for its winding number at points far away.
struct WindingMoments {
  Eigen::Vector3d center{Eigen::Vector3d::Zero()};  ///< [m] centroid of the area
  Eigen::Vector3d normal{Eigen::Vector3d::Zero()};  ///< [m^2] unit normals, summed over the area
  /// [m^3] offset from the center times unit normal, summed over the area and made symmetric: xx,
  /// yy, zz, xy, yz, zx.
  std::array<double, 6> spread{};
  double area{0.0};     ///< [m^2]
  double squared{0.0};  ///< [m^4] squared offset from the center, summed over the area
  double radius{0.0};   ///< [m] of a ball about the center that holds the part
};

WindingMoments momentsOf(const Triangle& triangle) noexcept;  ///< the moments of one triangle

/// The moments of both parts together. The radius is an upper bound.
WindingMoments joined(const WindingMoments& one, const WindingMoments& other) noexcept;

/// A number and an upper bound of its error.
struct BoundedNumber {
  double value{0.0};  ///< what was computed
  double error{0.0};  ///< >= 0; the true number is at most this far from `value`
};

/// The winding number that a part of a surface adds at a point outside the part's ball.
///
/// Expands (y - x) / |y - x|^3 about the center, to first order. Error: 3 / (4 pi d^4) * squared,
/// where d is the distance of the point from the ball, because no third derivative of 1 / r exceeds
/// 6 / r^4.
/// Source: Barill, Dickson, Schmidt, Levin, Jacobson, "Fast Winding Numbers for Soups and Clouds"
/// (2018), sections 3 and 4; the bound is ours.
BoundedNumber windingOf(const WindingMoments& part, const Eigen::Vector3d& point) noexcept;

/// The surface with triangles turned so that neighbours agree. Each connected part keeps the
/// direction that most of its area had. Of triangles with the same corners only one stays; the
/// others become their first corner three times. The order of vertices and triangles does not
/// change. Neighbours are two triangles that alone share an edge; equal vertices count as one.
TriangleMesh orientedSurface(const TriangleMesh& mesh);

/// By triangle: a bit for each side, from one corner to the next, at which the surface ends. Two
/// sides of an edge that run against each other cancel; the surface ends at those left over. Equal
/// vertices count as one.
std::vector<std::uint8_t> rimSidesOf(const TriangleMesh& mesh);

}  // namespace collision_monitor
