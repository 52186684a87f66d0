// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "collision_monitor/geometry/hull.h"
#include "collision_monitor/geometry/pose.h"
#include "narrow_phase/sat/hull_axes.h"

/// What the searches for the best axis among faces and among edges of two hulls share.
namespace collision_monitor {

/// Heights of known points are kept for this many faces. Later faces are always looked at.
constexpr std::size_t kMostAxisFaces = 128;

inline void offer(const HullAxis& candidate, HullAxis& best) noexcept {
  if (candidate.separation > best.separation) {
    best = candidate;
  }
}

/// Four points of a hull in columns, in the frame of the other hull, which owns the faces. The hull
/// is at least as far below a face as any of them.
struct KnownPoints {
  Eigen::Array4d x, y, z;

  void set(Eigen::Index i, const Eigen::Vector3d& point) noexcept {
    x[i] = point.x();
    y[i] = point.y();
    z[i] = point.z();
  }
  /// [m] Heights above a face.
  Eigen::Array4d above(const ConvexHull::Face& face) const noexcept {
    return face.normal.x() * x + face.normal.y() * y + face.normal.z() * z - face.offset;
  }
  double above(const ConvexHull::Face& face, Eigen::Index i) const noexcept {
    return face.normal.x() * x[i] + face.normal.y() * y[i] + face.normal.z() * z[i] - face.offset;
  }
};

/// A hull, and known points of the other.
struct KnownHull {
  const ConvexHull& hull;
  const KnownPoints& other;
};

/// Searches the cross products of edges for an axis that separates more.
/// Frames: A's.
/// @param best the best axis of both hulls' faces; receives the result.
void searchEdges(const KnownHull& a, const KnownHull& b, const Pose& a_from_b,
                 HullAxis& best) noexcept;

}  // namespace collision_monitor
