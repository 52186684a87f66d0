// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "collision_monitor/geometry/triangle_bvh.h"
#include "fitting/inner/medial_balls.h"

namespace collision_monitor {

/// A segment and its approximate distance to the surface.
struct InnerSegment {
  Eigen::Vector3d a{Eigen::Vector3d::Zero()};
  Eigen::Vector3d b{Eigen::Vector3d::Zero()};
  double radius{0.0};  ///< 0 when the segment comes near the surface or crosses it
};

/// The volume of the capsule around the segment.
double volumeOf(const InnerSegment& segment);

/// A segment with its radius, from balls along it, each of which holds the next center: if it
/// starts inside a solid, it stays inside. The radius is 0 if the segment comes nearer than
/// `least_radius`.
InnerSegment innerSegment(const TriangleBvh& surface, const Eigen::Vector3d& a,
                          const Eigen::Vector3d& b, double least_radius);

/// Moves a ball, or both ends of a segment, to where it can be larger, by local search. Steps stay
/// inside balls known to be empty, and so on the same side of the surface.
EmptyBall growBall(const TriangleBvh& surface, const EmptyBall& ball);
InnerSegment growSegment(const TriangleBvh& surface, const InnerSegment& segment);

}  // namespace collision_monitor
