// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "collision_monitor/geometry/hull.h"
#include "collision_monitor/geometry/mesh_tree.h"
#include "collision_monitor/geometry/pose.h"
#include "collision_monitor/geometry/triangle.h"
#include "collision_monitor/narrow_phase/convex_workspace.h"
#include "narrow_phase/closed_form/core_distance.h"

/// Two convex cores as GJK and EPA see them: through their support functions.
namespace collision_monitor {

/// A convex core. Points and segments are boxes without width.
struct ConvexCore {
  enum class Kind : unsigned char { box, cylinder, hull, triangle, part };

  Kind kind{Kind::box};
  Eigen::Vector3d half_extents{Eigen::Vector3d::Zero()};  ///< of a cylinder: (r, r, half length)
  const ConvexHull* hull{nullptr};                        ///< of a hull
  const Triangle* triangle{nullptr};                      ///< of a triangle
  const MeshTree* mesh{nullptr};                          ///< of a part of a mesh
  std::uint32_t node{0};                                  ///< that holds the part
};

/// True for a cylinder. It has no corners for a search to end on.
inline bool isSmooth(const ConvexCore& core) noexcept {
  return core.kind == ConvexCore::Kind::cylinder;
}

/// True for the core of a sphere.
inline bool isPoint(const ConvexCore& core) noexcept {
  return core.kind == ConvexCore::Kind::box && core.half_extents.isZero(0.0);
}

/// [m] Bounding radius about the core's origin.
inline double reachOf(const ConvexCore& core) noexcept {
  switch (core.kind) {
    case ConvexCore::Kind::box:
      return core.half_extents.norm();
    case ConvexCore::Kind::cylinder:
      return core.half_extents.tail<2>().norm();
    case ConvexCore::Kind::hull:
      return core.hull->boundingRadius();
    case ConvexCore::Kind::triangle:
      return std::sqrt(
          std::max({(*core.triangle)[0].squaredNorm(), (*core.triangle)[1].squaredNorm(),
                    (*core.triangle)[2].squaredNorm()}));
    case ConvexCore::Kind::part:
      return core.mesh->center().norm() + core.mesh->radius();
  }
  return 0.0;
}

/// The farthest point in `direction` (frame of the core, any length). The climb of a hull starts at
/// `vertex`, which receives its end.
Eigen::Vector3d supportPoint(const ConvexCore& core, const Eigen::Vector3d& direction,
                             std::uint32_t& vertex) noexcept;

/// Two cores in A's frame.
struct ConvexPair {
  ConvexCore a;
  ConvexCore b;
  Pose a_from_b;
  double size{0.0};  ///< [m] bounds every coordinate of the difference B - A
  /// Search hints; the answers do not depend on them.
  std::uint32_t vertex_of_a{0};
  std::uint32_t vertex_of_b{0};

  bool isSmooth() const noexcept {
    return collision_monitor::isSmooth(a) || collision_monitor::isSmooth(b);
  }
};

/// Pose of B in A, from poses in the world. Unlike inverse(a) * b it subtracts positions first.
Pose relativePose(const Pose& world_from_a, const Pose& world_from_b) noexcept;

ConvexPair makeConvexPair(const ConvexCore& a, const Pose& world_from_a, const ConvexCore& b,
                          const Pose& world_from_b) noexcept;

/// The point of B - A that is least far along `direction`.
SupportVertex leastAlong(const Eigen::Vector3d& direction, ConvexPair& pair) noexcept;

/// The difference of a point of B and a point of A, which need not be extreme.
SupportVertex differenceOf(const ConvexPair& pair, const Eigen::Vector3d& on_a,
                           const Eigen::Vector3d& on_b) noexcept;

/// [m] An upper bound of the rounding of a coordinate of the difference.
/// @param size see ConvexPair::size.
inline double roundingOf(double size) noexcept { return 4e-15 * size; }
inline double roundingOf(const ConvexPair& pair) noexcept { return roundingOf(pair.size); }

/// [m] Below this distance two cores count as touching.
inline double touchingDistance(double size) noexcept {
  return std::max(kTouching, roundingOf(size));
}
inline double touchingDistance(const ConvexPair& pair) noexcept {
  return touchingDistance(pair.size);
}

/// [m] Tolerance of smooth cores, which searches approach and never reach.
inline double smoothTolerance(double size) noexcept { return 1e-12 * size; }

/// [m] The lower and the upper bound meet if they differ by at most this. Searches reach polytopes
/// in finitely many steps, up to rounding. They only approach smooth cores.
inline double toleranceOf(const ConvexPair& pair) noexcept {
  return pair.isSmooth() ? smoothTolerance(pair.size) : roundingOf(pair);
}

}  // namespace collision_monitor
