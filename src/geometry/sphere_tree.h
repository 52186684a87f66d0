// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "collision_monitor/geometry/pose.h"

namespace collision_monitor {

/// A sphere that encloses one part of a surface.
struct SphereNode {
  Eigen::Vector3d center{Eigen::Vector3d::Zero()};
  double radius{0.0};
  double overshoot{0.0};  ///< [m] greatest distance of a sample of the sphere from the surface
  std::uint32_t first_child{0};
  std::uint32_t child_count{0};  ///< 0 for a leaf
  std::uint32_t level{0};        ///< 0 for the root
};

/// A hierarchy of spheres about a surface: breadth-first, root first, siblings side by side.
///
/// Each node stands for a part of the surface: the root for all of it, and the children of a node
/// together for that node's part. The sphere of a node encloses its part. Therefore
/// - the distance to a node's sphere is a lower bound of the distance to its part and to the parts
///   of its descendants, which matter only when the node is near;
/// - any set of nodes that cuts every path from the root to a leaf encloses the whole surface.
/// A child's sphere may extend beyond its parent's (its part does not). So the bound at a child is
/// the larger one of its own and its parent's.
///
/// The spheres enclose the surface, not the solid inside a closed surface. Finding a small body
/// deep inside a large one needs an inner shape too.
///
/// Frames: that of the geometry, unless placed. Units: metres.
struct SphereTree {
  std::vector<SphereNode> nodes;
};

/// The number of levels: one more than the level of the deepest leaf; 0 for a tree without nodes.
std::uint32_t levelCount(const SphereTree& tree) noexcept;

/// The nodes of a level and the leaves above it, which enclose the whole surface. A level beyond
/// the last gives the leaves.
std::vector<SphereNode> spheresOfLevel(const SphereTree& tree, std::uint32_t level);

/// The tree in another frame: the stored `link_from_geometry` is applied to the surface.
/// Error: radii grow by the rounding error of the pose and of its application, about 1e-15 of the
/// lengths if the rotation is orthonormal up to rounding.
SphereTree placed(const SphereTree& tree, const Pose& link_from_geometry);

}  // namespace collision_monitor
