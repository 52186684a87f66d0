// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>

namespace collision_monitor {

/// A flat feature seen in the plane of a face: a point, a segment or a parallelogram, as
/// center + u * sides[0] + v * sides[1] with |u|, |v| <= 1.
struct FlatFeature {
  Eigen::Vector2d center{Eigen::Vector2d::Zero()};
  Eigen::Vector2d sides[2];
  int side_count{0};
};

/// Finds the center of the part of `feature` over the rectangle |x| <= half_extents: the centroid
/// of a polygon, the middle of a segment.
///
/// Limits: a feature that misses the rectangle by less than `tolerance` still counts.
/// @return false if there is no such part; `center` then means nothing.
/// Source: Sutherland, Hodgman, "Reentrant polygon clipping" (1974).
bool patchCenter(const FlatFeature& feature, const Eigen::Vector2d& half_extents, double tolerance,
                 Eigen::Vector2d& center) noexcept;

/// The centroid of a convex polygon of either orientation. For one thinner than rounding, which is
/// a segment, the middle of its bounds.
/// @pre count >= 1
Eigen::Vector2d centroidOf(const Eigen::Vector2d* corners, std::size_t count) noexcept;

}  // namespace collision_monitor
