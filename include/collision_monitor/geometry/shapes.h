// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <variant>

namespace collision_monitor {

/// Convex shapes as a core and a radius, each centered at the origin of its own body frame.
///
/// The shape is every point within `radius` of its core: a point (sphere), a segment along z
/// (capsule), a box (oriented box, rounded box). So the signed distance of two shapes is the signed
/// distance of their cores minus both radii, and a few core routines serve the whole family.
///
/// Units: metres. Every length is finite and >= 0; zero is legal everywhere.

/// Core: the origin.
struct Sphere {
  double radius{0.0};  ///< [m]
};

/// Core: the segment from (0, 0, -half_length) to (0, 0, +half_length).
struct Capsule {
  double half_length{0.0};  ///< [m] without the cap
  double radius{0.0};       ///< [m]
};

/// Core: the box itself; its radius is 0.
struct Box {
  Eigen::Vector3d half_extents{Eigen::Vector3d::Zero()};  ///< [m] along x, y, z
};

/// A box inflated by a radius. `half_extents` belong to the core, so the shape extends to
/// half_extents + radius along each axis. A zero half extent makes the core a rectangle.
struct RoundedBox {
  Eigen::Vector3d half_extents{Eigen::Vector3d::Zero()};  ///< [m] along x, y, z
  double radius{0.0};                                     ///< [m] added on all sides
};

/// Axis along z. Only a geometry of a URDF, not an enclosing shape.
struct Cylinder {
  double half_length{0.0};  ///< [m]
  double radius{0.0};       ///< [m]
};

/// The closed set of shapes that enclose a link's geometry.
using Shape = std::variant<Sphere, Capsule, Box, RoundedBox>;

/// The kinds of core, in the order in which pairs are grouped.
enum class CoreKind : unsigned char { point, segment, box };

/// Half extents of the core along x, y, z; zero where the core has none.
Eigen::Vector3d coreHalfExtents(const Shape& shape) noexcept;
double radiusOf(const Shape& shape) noexcept;      ///< the radius around the core; 0 for a Box
CoreKind coreKindOf(const Shape& shape) noexcept;  ///< the kind of the shape's core

/// "sphere", "capsule", "box" or "rounded_box", as in messages and files.
const char* kindName(const Shape& shape) noexcept;

/// Units: cubic metres.
double volumeOf(const Shape& shape) noexcept;

/// The farthest point of the shape in `direction` (body frame, need not be unit).
/// Limits: for a zero direction, any point of the shape.
Eigen::Vector3d supportPoint(const Shape& shape, const Eigen::Vector3d& direction) noexcept;

/// Signed distance of a point to the surface, negative inside.
/// Frames: `point` in the body frame.
double signedDistanceTo(const Shape& shape, const Eigen::Vector3d& point) noexcept;

}  // namespace collision_monitor
