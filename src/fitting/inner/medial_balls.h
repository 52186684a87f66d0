// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/geometry/triangle_bvh.h"

namespace collision_monitor {

/// A ball that holds no point of the surface.
struct EmptyBall {
  Eigen::Vector3d center{Eigen::Vector3d::Zero()};
  double radius{0.0};
};

/// Empty balls inside a closed surface that touch it at about two points, largest first. They start
/// from `count` points spread over its area; always the same ones.
///
/// A ball starts at a point of the surface, along the inward normal, and shrinks until it is empty.
/// Faults of the surface may put a ball outside. A caller that needs a proof checks the winding
/// number.
/// Source: Ma, Bae, Choi, "3D medial axis point approximation using nearest neighbors and the
/// normal field" (2012), section 3.
/// @pre triangles are counter-clockwise seen from outside.
std::vector<EmptyBall> medialBalls(const TriangleBvh& surface, int count);

/// Keeps at most `most` balls whose centers lie in no larger kept ball. @pre largest first.
std::vector<EmptyBall> separateBalls(const std::vector<EmptyBall>& balls, std::size_t most);

}  // namespace collision_monitor
