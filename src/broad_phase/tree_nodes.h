// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "collision_monitor/geometry/pose.h"

namespace collision_monitor {

constexpr std::size_t kTreeChildren = 8;

/// The boxes of the children of a node, by axis and child. Missing children have boxes of NaN.
struct alignas(64) TreeNode {
  float min[3][kTreeChildren];  ///< [m]
  float max[3][kTreeChildren];  ///< [m]
};

/// An oriented box in the frame of a tree, and how near to it is near.
struct NearBox {
  float axes[3][3];  ///< unit vectors
  float center[3];   ///< [m]
  float half[3];     ///< [m] along its axes
  float within;      ///< [m] may be infinite
  float min[3];      ///< [m] everything near has a box in the frame of the tree that meets this one
  float max[3];      ///< [m]
};

/// Which test children pass.
enum class NearTest : unsigned char {
  rough,  ///< boxes along the axes of the tree meet
  fine,   ///< also, they are near along the axes of the oriented box
};

/// Numbers of nodes.
struct SomeNodes {
  const std::uint32_t* first;
  std::size_t count;
};

/// @param tree_from_box a rigid pose
/// @param half [m] along the axes of the box, finite
/// @param within [m] NaN counts as infinite
NearBox nearBoxOf(const Pose& tree_from_box, const Eigen::Vector3d& half, double within) noexcept;

/// Writes the children of some nodes that may be as near as the box asks, in order: child k of node
/// i as kTreeChildren * i + k. The instruction set is chosen at run time.
/// Error: writes every child that is near, and some that are not.
/// @param nodes of one level, the children of `which.count` of which are tested
/// @pre `found` has room for kTreeChildren * (which.count + 1) numbers.
/// @return how many were written
std::size_t findNearChildren(const TreeNode* nodes, const SomeNodes& which, const NearBox& box,
                             NearTest test, std::uint32_t* found) noexcept;

}  // namespace collision_monitor
