// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/geometry/triangle_bvh.h"

namespace collision_monitor {

/// A ball without a point of the surface in it.
struct EmptyBall {
  Eigen::Vector3d center{Eigen::Vector3d::Zero()};
  double radius{0.0};
};

/// Empty balls inside a closed surface that touch it about twice, from `count` points spread over
/// its area, largest first; the same ones every time.
///
/// From a point of the surface a ball is let in along the inward normal and shrunk until nothing is
/// in it. A ball that lies outside after all, by a fault of the surface, is possible: who needs a
/// proof looks at the winding number.
/// Source: Ma, Bae, Choi, "3D medial axis point approximation using nearest neighbors and the
/// normal field" (2012), section 3.
/// @pre triangles are counter-clockwise seen from outside.
std::vector<EmptyBall> medialBalls(const TriangleBvh& surface, int count);

/// Of balls, largest first, those whose centers lie in no larger one that was kept, at most `most`.
std::vector<EmptyBall> separateBalls(const std::vector<EmptyBall>& balls, std::size_t most);

}  // namespace collision_monitor
