// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "collision_monitor/geometry/pose.h"
#include "collision_monitor/geometry/shapes.h"
#include "collision_monitor/narrow_phase/signed_distance.h"

/// Contact manifolds: all the places where two convex shapes are as near as they get, not one.
///
/// Frames: world. Units: metres. Sign: as SignedDistance.
/// Source: features and clipping as in Ericson, "Real-Time Collision Detection" (2005), section
/// 5.5.1; Sutherland, Hodgman, "Reentrant polygon clipping" (1974).
namespace collision_monitor {

/// What touches what, A's feature and B's in either order.
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

/// Points that face each other along the normal, each on (or, for a radius seen at a slant, in) its
/// shape. Those of edges that are only nearly parallel may miss each other sideways by 0.1 mm.
struct ManifoldPoint {
  Eigen::Vector3d point_on_a{Eigen::Vector3d::Zero()};
  Eigen::Vector3d point_on_b{Eigen::Vector3d::Zero()};
  double distance{0.0};  ///< (point_on_b - point_on_a) along the normal: minus the depth here
};

struct ContactManifold {
  static constexpr std::size_t kMaxPoints = 4;

  std::array<ManifoldPoint, kMaxPoints> points;
  std::size_t size{0};   ///< 1 to 4
  ManifoldPoint center;  ///< the mean of the points: does not jump from end to end
  Eigen::Vector3d normal_a_to_b{Eigen::Vector3d::UnitX()};
  ContactFeature feature{ContactFeature::vertex_vertex};
};

/// A flat convex feature of a shape: a corner, an edge, or the ring of a face's corners.
struct ContactPatch {
  static constexpr std::size_t kMaxCorners = 16;

  std::array<Eigen::Vector3d, kMaxCorners> corners;
  std::size_t size{0};
};

/// Features at a slant of up to this sine to the contact plane are tried for a flat contact...
constexpr double kFlatSine = 0.05;
/// ... and points count that are less than this [m] farther apart than the nearest.
constexpr double kPatchDepth = 1e-3;

/// The manifold of two features that face each other.
///
/// Faces are clipped against the sides of the face that is more square to the normal; of what is
/// left the nearest point and those that spread farthest stay. Edges give two points where they
/// run beside each other, and one where they cross.
/// Limits: no point is nearer than `measured`; a corner, a crossing, and features that rounding
/// keeps apart give its points as the only ones.
/// @param measured along whose normal the features are extreme.
ContactManifold manifoldOf(const ContactPatch& on_a, const ContactPatch& on_b,
                           const SignedDistance& measured) noexcept;

/// The manifold of two shapes of the core + radius family: cube on table four points, capsule on
/// box or beside a parallel one two, crossed boxes one.
///
/// Limits: the feature names are those of the cores: a sphere is a vertex, a capsule an edge with
/// two ends.
/// @param measured the answer of distanceBetween for this pair.
/// @pre poses are finite and rigid.
ContactManifold manifoldBetween(const Shape& a, const Pose& world_from_a, const Shape& b,
                                const Pose& world_from_b, const SignedDistance& measured) noexcept;

}  // namespace collision_monitor
