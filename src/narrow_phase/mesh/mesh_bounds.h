// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "collision_monitor/geometry/mesh_tree.h"
#include "collision_monitor/geometry/pose.h"

/// Lower bounds of the distances between the children of a MeshTree node and a bound in another
/// frame. They are in single precision and still proven.
namespace collision_monitor {

/// Bounds of the children of a node.
struct alignas(64) NodeBounds {
  float squared[MeshTreeNode::kWidth];  ///< [m^2] lower bound; 0: may touch; 1e36: empty slot
  /// [m] The gap along the line of centers, negative if shadows overlap. Decides which child is
  /// looked at first, also among those that may touch.
  float order[MeshTreeNode::kWidth];
};

/// A box and a slab that both hold what is bounded, in the frame they were made in.
struct Bound {
  Eigen::Vector3f center;
  Eigen::Vector3f half;
  Eigen::Vector3f normal;  ///< at most of unit length
  float slab_center;
  float slab_half;
};

/// A bound in the frame of the node that it is compared with.
struct PlacedBound {
  Eigen::Vector3f center;
  Eigen::Matrix3f sides;  ///< columns: half edges of the box
  Eigen::Vector3f reach;  ///< half extents of the box about `sides`, plus the slack
  Eigen::Vector3f normal;
  float slab_center;
  float slab_half;  ///< plus the slack
  float slack;      ///< [m] for two heights along one direction
};

/// The transform from one tree's frame to another's, for bounds.
struct BoundPlacement {
  Eigen::Matrix3f rotation;
  Eigen::Vector3f translation;
  /// [m] Subtracted from every gap. With u = 2^-24 and coordinates up to S, a placed center and a
  /// sum of half extents are off by less than 12 u S. A height along a normal (three products of
  /// numbers that are each off by 12 u of their size, twice) is off by less than 80 u S.
  float slack;
};

/// @param size bounds every coordinate in either frame: both radii plus the distance of the frames.
BoundPlacement makePlacement(const Pose& a_from_b, double size) noexcept;

/// The bound of a slot.
Bound boundOf(const MeshTreeNode& node, std::uint32_t slot) noexcept;

PlacedBound place(const BoundPlacement& placement, const Bound& bound) noexcept;

/// Lower bounds of the distances between the children and `other`. Uses the widest vector
/// instructions of the machine; all give the same bits.
/// @return a bit for each child whose squared bound is below `limit`.
std::uint32_t boundNearer(const MeshTreeNode& node, const PlacedBound& other, float limit,
                          NodeBounds& bounds) noexcept;

/// A triangle in the frame of the node that it is compared with.
struct PlacedTriangle {
  std::array<Eigen::Vector3f, 3> corners;
  float slack;  ///< [m] as BoundPlacement::slack
};

/// @param center of the triangle's tree
PlacedTriangle place(const BoundPlacement& placement, const Eigen::Vector3d& center,
                     const Triangle& triangle) noexcept;

/// The same for a triangle, which is bounded by itself. A box about a large slanted triangle holds
/// much that is far from it.
std::uint32_t boundNearer(const MeshTreeNode& node, const PlacedTriangle& other, float limit,
                          NodeBounds& bounds) noexcept;

/// [m] How far `other` lies beyond each child along a unit vector in the node's frame, rounded
/// down. Far below 0 for empty slots.
std::array<float, MeshTreeNode::kWidth> gapsAlong(const MeshTreeNode& node,
                                                  const PlacedBound& other,
                                                  const Eigen::Vector3f& direction) noexcept;
std::array<float, MeshTreeNode::kWidth> gapsAlong(const MeshTreeNode& node,
                                                  const PlacedTriangle& other,
                                                  const Eigen::Vector3f& direction) noexcept;

/// Number of unit vectors tried at once.
constexpr std::size_t kDirections = MeshTreeNode::kWidth;
struct alignas(32) Directions {
  float at[3][kDirections];
};

/// The same for one child along each direction.
std::array<float, kDirections> gapsAlong(const Bound& child, const PlacedBound& other,
                                         const Directions& directions) noexcept;
std::array<float, kDirections> gapsAlong(const Bound& child, const PlacedTriangle& other,
                                         const Directions& directions) noexcept;

}  // namespace collision_monitor
