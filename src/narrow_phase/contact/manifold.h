// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "collision_monitor/geometry/pose.h"
#include "collision_monitor/geometry/shapes.h"
#include "collision_monitor/narrow_phase/signed_distance.h"

/// Contact manifolds: all places where two convex shapes are at their least distance.
///
/// Frames: world. Units: metres. Sign: as SignedDistance.
/// Source: features and clipping as in Ericson, "Real-Time Collision Detection" (2005), section
/// 5.5.1; Sutherland, Hodgman, "Reentrant polygon clipping" (1974).
namespace collision_monitor {

/// Which features touch, A's and B's in either order.
enum class ContactFeature : unsigned char {
  vertex_vertex,
  vertex_edge,
  vertex_face,
  edge_edge,
  edge_face,
  face_face,
};

/// "vertex_face" and so on, as in messages.
const char* nameOf(ContactFeature feature) noexcept;

/// Two points that face each other along the normal. Each is on its shape, or inside it for a
/// radius seen at a slant. On nearly parallel edges they may miss each other sideways by 0.1 mm.
struct ManifoldPoint {
  Eigen::Vector3d point_on_a{Eigen::Vector3d::Zero()};
  Eigen::Vector3d point_on_b{Eigen::Vector3d::Zero()};
  double distance{0.0};  ///< (point_on_b - point_on_a) . normal: minus the depth here
};

struct ContactManifold {
  static constexpr std::size_t kMaxPoints = 4;

  std::array<ManifoldPoint, kMaxPoints> points;
  std::size_t size{0};   ///< 1 to 4
  ManifoldPoint center;  ///< mean of the points; does not jump from end to end
  Eigen::Vector3d normal_a_to_b{Eigen::Vector3d::UnitX()};
  ContactFeature feature{ContactFeature::vertex_vertex};
};

/// A flat convex feature of a shape: a corner, an edge, or the ring of a face's corners.
struct ContactPatch {
  static constexpr std::size_t kMaxCorners = 16;

  std::array<Eigen::Vector3d, kMaxCorners> corners;
  std::size_t size{0};
};

/// Features within this sine of the contact plane are tried for a flat contact.
constexpr double kFlatSine = 0.05;
/// [m] Points farther apart than the nearest ones by more than this do not count.
constexpr double kPatchDepth = 1e-3;

/// The manifold of two features that face each other.
///
/// Two faces are clipped by the sides of the face that is more square to the normal. The nearest
/// point and the points that spread farthest remain. Edges give two points if they run beside each
/// other, one if they cross.
/// Limits: no point is nearer than `measured`. A corner, a crossing, and features that rounding
/// keeps apart give the points of `measured` alone.
/// @param measured its normal is the direction in which the features are extreme.
ContactManifold manifoldOf(const ContactPatch& on_a, const ContactPatch& on_b,
                           const SignedDistance& measured) noexcept;

/// The manifold of two shapes of the core + radius family: four points for a cube on a table, two
/// for a capsule on a box or beside a parallel capsule, one for crossed boxes.
///
/// Limits: features are named by the cores: a sphere is a vertex, a capsule an edge with two ends.
/// @param measured the answer of distanceBetween for this pair.
/// @pre poses are finite and rigid.
ContactManifold manifoldBetween(const Shape& a, const Pose& world_from_a, const Shape& b,
                                const Pose& world_from_b, const SignedDistance& measured) noexcept;

}  // namespace collision_monitor
