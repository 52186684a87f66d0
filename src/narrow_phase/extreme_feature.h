// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "narrow_phase/convex_pair.h"

namespace collision_monitor {

/// Features count as level, and edges as parallel, up to this sine.
constexpr double kLevelSine = 1e-11;

/// What of a core is farthest in a direction.
struct ExtremeFeature {
  const ConvexCore& core;
  Eigen::Vector3d direction;  ///< unit, in the frame of the core
  std::uint32_t vertex;       ///< of a hull
  double reach;               ///< [m] along the direction, from the core's origin
  bool may_be_level;          ///< false: nothing but a vertex for certain
};

/// `vertex` is where a hull's climb starts.
/// Error: see ConvexHull::supportVertex.
ExtremeFeature extremeOf(const ConvexCore& core, const Eigen::Vector3d& direction,
                         std::uint32_t vertex) noexcept;

/// Whether the features of A and B that face each other share more than a point: a face and an
/// edge or face, or two parallel edges.
bool areLevel(const ExtremeFeature& of_a, const Eigen::Matrix3d& world_from_a,
              const ExtremeFeature& of_b, const Eigen::Matrix3d& world_from_b) noexcept;

}  // namespace collision_monitor
