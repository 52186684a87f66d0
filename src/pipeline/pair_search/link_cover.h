// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/pipeline/setup.h"
#include "motion/conservative_advancement.h"

/// Simple things that enclose or fill elements, in the frame of their link, for bounds that are
/// asked for very often.
namespace collision_monitor {

/// An element lies within `radius` of the convex hull of the points.
struct PointCover {
  std::vector<Eigen::Vector3d> points;
  double radius{0.0};
};

/// A convex geometry that lies in an element, and its ball.
struct InnerConvex {
  ConvexGeometry geometry;
  Pose link_from_geometry;
  Ball ball;  ///< in the frame of the link
};

struct ElementCover {
  Ball ball;                ///< about all of it
  std::vector<Ball> balls;  ///< every one of its bodies lies in their union
  PointCover hull;
  std::vector<InnerConvex> inner;  ///< none if the element only encloses its geometry
};

/// By ElementId.
std::vector<ElementCover> coverElements(const CycleSetup& setup);

}  // namespace collision_monitor
