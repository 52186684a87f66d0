// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "collision_monitor/geometry/pose.h"

namespace collision_monitor {

/// A sphere about one part of a surface.
struct SphereNode {
  Eigen::Vector3d center{Eigen::Vector3d::Zero()};
  double radius{0.0};
  double overshoot{0.0};  ///< [m] the farthest that a sample of the sphere is from the surface
  std::uint32_t first_child{0};
  std::uint32_t child_count{0};  ///< 0 for a leaf
  std::uint32_t level{0};        ///< 0 for the root
};

/// A hierarchy of spheres about a surface, breadth-first, root first; children stand side by side.
///
/// Each node stands for a part of the surface: the root for all of it, the children of a node
/// together for the part of that node. Its sphere encloses its part, and therefore
/// - the distance to a node's sphere is a lower bound of the distance to its part, and to whatever
///   its descendants stand for: they need to be looked at only when their parent is near;
/// - any set of nodes that cuts every path from the root to a leaf encloses the whole surface.
/// A child's sphere may reach beyond its parent's (its part does not), so a bound taken from a
/// child is the larger one of its own and its parent's.
///
/// The surface is enclosed, not the solid that a closed one bounds: what is to find a small body
/// deep inside a large one needs an inner shape too.
///
/// Frames: that of the geometry, unless placed elsewhere. Units: metres.
struct SphereTree {
  std::vector<SphereNode> nodes;
};

/// Number of levels: that of the deepest leaf and 1; 0 for a tree without nodes.
std::uint32_t levelCount(const SphereTree& tree) noexcept;

/// The nodes of a level, and the leaves above it: they enclose the whole surface. A level below
/// the last gives the leaves.
std::vector<SphereNode> spheresOfLevel(const SphereTree& tree, std::uint32_t level);

/// The tree seen from another frame: `link_from_geometry` as stored is applied to the surface.
/// Error: radii grow by what the pose and its application may lack in rounding, about 1e-15 of the
/// lengths for a rotation that is orthonormal up to rounding.
SphereTree placed(const SphereTree& tree, const Pose& link_from_geometry);

}  // namespace collision_monitor
