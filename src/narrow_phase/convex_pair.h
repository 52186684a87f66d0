// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "collision_monitor/geometry/hull.h"
#include "collision_monitor/geometry/pose.h"
#include "collision_monitor/geometry/triangle.h"
#include "collision_monitor/narrow_phase/convex_workspace.h"

/// Two convex cores as GJK and EPA see them: by their support functions alone.
namespace collision_monitor {

/// A point and a segment are boxes without width.
struct ConvexCore {
  enum class Kind : unsigned char { box, cylinder, hull, triangle };

  Kind kind{Kind::box};
  Eigen::Vector3d half_extents{Eigen::Vector3d::Zero()};  ///< of a cylinder: radius, radius, half
  const ConvexHull* hull{nullptr};                        ///< of a hull
  const Triangle* triangle{nullptr};                      ///< of a triangle
};

/// [m] radius about the core's origin that holds it.
double reachOf(const ConvexCore& core) noexcept;

/// The farthest point in `direction` (frame of the core, any length).
/// `vertex` is where a hull's climb starts and ends.
Eigen::Vector3d supportPoint(const ConvexCore& core, const Eigen::Vector3d& direction,
                             std::uint32_t& vertex) noexcept;

/// Both cores in A's frame.
struct ConvexPair {
  ConvexCore a;
  ConvexCore b;
  Pose a_from_b;
  double size{0.0};  ///< [m] bounds every coordinate of the difference B - A
  /// Search hints; the answers do not depend on them.
  std::uint32_t vertex_of_a{0};
  std::uint32_t vertex_of_b{0};

  /// A cylinder has no corners that a search could end on.
  bool isSmooth() const noexcept {
    return a.kind == ConvexCore::Kind::cylinder || b.kind == ConvexCore::Kind::cylinder;
  }
};

ConvexPair makeConvexPair(const ConvexCore& a, const Pose& world_from_a, const ConvexCore& b,
                          const Pose& world_from_b) noexcept;

/// The point of B - A that is least far along `direction`.
SupportVertex leastAlong(const Eigen::Vector3d& direction, ConvexPair& pair) noexcept;

/// A point of A and a point of B, which need not be extreme.
SupportVertex differenceOf(const ConvexPair& pair, const Eigen::Vector3d& on_a,
                           const Eigen::Vector3d& on_b) noexcept;

/// Rounding that a coordinate of the difference may carry, and some to spare.
inline double roundingOf(const ConvexPair& pair) noexcept { return 4e-15 * pair.size; }

/// The bounds from below and above that are to meet: as near as rounding allows for polytopes,
/// which searches reach by finite steps. Smooth cores are approached only.
inline double toleranceOf(const ConvexPair& pair) noexcept {
  return pair.isSmooth() ? 1e-12 * pair.size : roundingOf(pair);
}

}  // namespace collision_monitor
