// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "narrow_phase/contact/manifold.h"

/// The pieces of manifolds.
namespace collision_monitor {

/// Each side of a face adds at most one corner to the polygon that it cuts.
constexpr std::size_t kMaxClipped = 2 * ContactPatch::kMaxCorners;

/// A convex polygon while it is being clipped; an edge is a polygon of two corners.
struct ClippedPolygon {
  std::array<Eigen::Vector3d, kMaxClipped> corners;
  std::size_t size{0};

  void add(const Eigen::Vector3d& corner) noexcept {
    if (size < corners.size()) {
      corners[size++] = corner;
    }
  }
};

/// Candidates for a manifold.
struct ManifoldPoints {
  std::array<ManifoldPoint, kMaxClipped> points;
  std::size_t size{0};

  void add(const ManifoldPoint& point) noexcept {
    if (size < points.size()) {
      points[size++] = point;
    }
  }
};

/// Finds the feature of a shape that is extreme in `direction` (unit), on its surface: a face or an
/// edge that is flat up to the sine `flat_sine`, or a vertex. Frames: world.
ContactPatch extremePatch(const Shape& shape, const Pose& world_from_shape,
                          const Eigen::Vector3d& direction, double flat_sine = kFlatSine) noexcept;

/// Edges within both limits run beside each other.
struct EdgeSlack {
  double sine;      ///< of the angle between them
  double sideways;  ///< [m] their offset across the normal
};

/// Finds the points at which the features face each other along `normal`: the corners of a polygon
/// in order, or two ends, in the plane of either feature. Crossing edges give none.
ManifoldPoints facingPoints(const ContactPatch& on_a, const ContactPatch& on_b,
                            const Eigen::Vector3d& normal, const EdgeSlack& slack) noexcept;

/// Keeps the part with outward . (x - through) <= 0.
void cut(const Eigen::Vector3d& outward, const Eigen::Vector3d& through,
         ClippedPolygon& polygon) noexcept;

/// Keeps points with distance <= limit.
void dropFarther(double limit, ManifoldPoints& points) noexcept;

/// Keeps the nearest point, the point farthest from it, and on either side the point that widens
/// the area most. Sets the center. Points within a nanometre of each other are one.
/// @pre points.size >= 1
void spreadOut(const ManifoldPoints& points, ContactManifold& manifold) noexcept;

}  // namespace collision_monitor
