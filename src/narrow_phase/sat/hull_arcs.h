// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "collision_monitor/geometry/hull.h"
#include "collision_monitor/geometry/pose.h"
#include "narrow_phase/sat/hull_axes.h"

/// What the searches for the best axis among faces and among edges of two hulls share.
namespace collision_monitor {

/// What a few points of one hull say of the faces of the other is kept of so many faces; those
/// beyond are looked at in any case.
constexpr std::size_t kMostAxisFaces = 128;

inline void offer(const HullAxis& candidate, HullAxis& best) noexcept {
  if (candidate.separation > best.separation) {
    best = candidate;
  }
}

/// Four points of a hull, in columns and in the frame of the other, the owner of the faces. What
/// one of them is below a face, the hull is at least.
struct KnownPoints {
  Eigen::Array4d x, y, z;

  void set(Eigen::Index i, const Eigen::Vector3d& point) noexcept {
    x[i] = point.x();
    y[i] = point.y();
    z[i] = point.z();
  }
  /// [m]
  Eigen::Array4d above(const ConvexHull::Face& face) const noexcept {
    return face.normal.x() * x + face.normal.y() * y + face.normal.z() * z - face.offset;
  }
  double above(const ConvexHull::Face& face, Eigen::Index i) const noexcept {
    return face.normal.x() * x[i] + face.normal.y() * y[i] + face.normal.z() * z[i] - face.offset;
  }
};

/// A hull, and what is known of the other.
struct KnownHull {
  const ConvexHull& hull;
  const KnownPoints& other;
};

/// Looks among the cross products of edges for an axis that separates more.
/// Frames: A's.
/// @param best the best of both hulls' faces.
void searchEdges(const KnownHull& a, const KnownHull& b, const Pose& a_from_b,
                 HullAxis& best) noexcept;

}  // namespace collision_monitor
