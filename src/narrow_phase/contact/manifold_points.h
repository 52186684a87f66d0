// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "narrow_phase/contact/manifold.h"

/// The pieces that manifolds are made of.
namespace collision_monitor {

/// Each side of a face adds one corner to what it cuts, at most.
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

/// The feature of a shape that is extreme in `direction` (unit), on its surface: a face or an edge
/// that is flat to `flat_sine`, or a vertex. World frame.
ContactPatch extremePatch(const Shape& shape, const Pose& world_from_shape,
                          const Eigen::Vector3d& direction, double flat_sine = kFlatSine) noexcept;

/// Edges run beside each other where neither is exceeded.
struct EdgeSlack {
  double sine;      ///< of the angle between them
  double sideways;  ///< [m] how far they pass each other, seen along the normal
};

/// Where the features face each other along `normal`, A's point first: the corners of a polygon in
/// turn, or two ends, in one plane with either feature; none where edges cross.
ManifoldPoints facingPoints(const ContactPatch& on_a, const ContactPatch& on_b,
                            const Eigen::Vector3d& normal, const EdgeSlack& slack) noexcept;

/// Keeps the part with outward . (x - through) <= 0.
void cut(const Eigen::Vector3d& outward, const Eigen::Vector3d& through,
         ClippedPolygon& polygon) noexcept;

/// Keeps points with distance <= limit.
void dropFarther(double limit, ManifoldPoints& points) noexcept;

/// Keeps the nearest point, the one farthest from it, and those that widen the area most, one on
/// either side; sets the center. Points nearer to each other than a nanometre are one.
/// @pre points.size >= 1
void spreadOut(const ManifoldPoints& points, ContactManifold& manifold) noexcept;

}  // namespace collision_monitor
