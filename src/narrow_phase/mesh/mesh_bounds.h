// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "collision_monitor/geometry/mesh_tree.h"
#include "collision_monitor/geometry/pose.h"

/// Lower bounds of distances between the children of a MeshTree and a bound in another frame, in
/// single precision and still proven.
namespace collision_monitor {

/// Of each child of a node.
struct alignas(64) NodeBounds {
  float squared[MeshTreeNode::kWidth];  ///< [m^2] of a lower bound; 0: may touch; 1e36: empty slot
  /// [m] the gap along the line of centers, negative where shadows overlap: which child to look at
  /// first, also among those that may touch.
  float order[MeshTreeNode::kWidth];
};

/// A box and a slab, both of which hold what is bounded, in the frame in which they were made.
struct Bound {
  Eigen::Vector3f center;
  Eigen::Vector3f half;
  Eigen::Vector3f normal;  ///< at most of unit length
  float slab_center;
  float slab_half;
};

/// A bound in the frame of the node it is held against.
struct PlacedBound {
  Eigen::Vector3f center;
  Eigen::Matrix3f sides;  ///< columns: half edges of the box
  Eigen::Vector3f reach;  ///< half extents of the box about `sides`, and the slack
  Eigen::Vector3f normal;
  float slab_center;
  float slab_half;  ///< and the slack
  float slack;      ///< [m] of two heights along one direction
};

/// The way from one tree's frame to another's, for bounds.
struct BoundPlacement {
  Eigen::Matrix3f rotation;
  Eigen::Vector3f translation;
  /// [m] Taken from every gap. With u = 2^-24 and no coordinate beyond S, a placed center is off by
  /// less than 12 u S, a sum of half extents by as much, a height along a normal (three products
  /// of numbers that each are off by 12 u of their size, twice) by less than 80 u S.
  float slack;
};

/// @param size bounds every coordinate that either frame will see: both radii and the way between.
BoundPlacement makePlacement(const Pose& a_from_b, double size) noexcept;

/// The bound that stands in a slot.
Bound boundOf(const MeshTreeNode& node, std::uint32_t slot) noexcept;

PlacedBound place(const BoundPlacement& placement, const Bound& bound) noexcept;

/// Lower bounds of the distances between the children and `other`, with the widest vector
/// instructions the machine has; each of them gives the same bits.
/// @return a bit for each child whose squared bound is below `limit`.
std::uint32_t boundNearer(const MeshTreeNode& node, const PlacedBound& other, float limit,
                          NodeBounds& bounds) noexcept;

/// [m] How far `other` lies beyond each child along a unit vector, in the node's frame; rounded
/// down. Of empty slots it is far below 0.
std::array<float, MeshTreeNode::kWidth> gapsAlong(const MeshTreeNode& node,
                                                  const PlacedBound& other,
                                                  const Eigen::Vector3f& direction) noexcept;

/// Unit vectors that are tried at once.
constexpr std::size_t kDirections = MeshTreeNode::kWidth;
struct alignas(32) Directions {
  float at[3][kDirections];
};

/// The same of one child along each.
std::array<float, kDirections> gapsAlong(const Bound& child, const PlacedBound& other,
                                         const Directions& directions) noexcept;

}  // namespace collision_monitor
