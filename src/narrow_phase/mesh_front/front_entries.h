// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "narrow_phase/mesh/mesh_search.h"

/// What one search leaves for the next as two things move; see MeshFront. Units: metres.
namespace collision_monitor {

/// A moving mesh seen from something that rests, and balls that hold both, each in its own frame.
struct FollowedPair {
  const Pose& resting_from_moving;
  const MeshTree& moving;
  Eigen::Vector3d center_of_resting;
  double radius_of_resting;
  double side;      ///< 1: directions lead from the resting to the moving one; -1: the reverse
  double rounding;  ///< [m] as MeshPair::rounding
};

/// Which side of a node pair moves.
struct MovingBounds {
  const MeshTree* tree{nullptr};
  bool is_a{false};
  double units_per_metre{0.0};  ///< of the coordinates in MeshFront::center
};

MovingBounds movingBounds(const MeshTree& tree, bool is_a) noexcept;

/// A pair as the front keeps it.
struct FrontEntry {
  MeshFront::Kept pair;
  double bound;             ///< [m]
  std::uint32_t direction;  ///< as MeshFront::direction
  std::uint32_t children;   ///< a bit for each child that is meant; 0: all
};

/// Updates the front to the current poses.
/// @return an upper bound of how far any point of one has moved, seen from the other, since the
/// last query; infinity if there was none.
double follow(const FollowedPair& pair, MeshFront& front) noexcept;

/// Rounds a goal up, so that every bound in single precision that may be nearer is below it.
float roundedUp(double goal) noexcept;

/// True if nothing that was dropped is nearer than the goal, and the kept pairs that may be nearer
/// are no more than the visits of the search from the roots.
bool covers(double squared_goal, const MeshFront& front) noexcept;

/// The block of a pair; placeOf() is its place there.
inline MeshFront::Block& blockOf(std::uint32_t at, const MeshFront& front) noexcept {
  return *front.blocks[at / MeshFront::kBlockSize];
}
inline std::size_t placeOf(std::uint32_t at) noexcept { return at % MeshFront::kBlockSize; }

/// Takes a block if needed. @return false if there is no room for one more pair.
bool ensureRoom(MeshFront& front) noexcept;

/// Drops all pairs: a search from the roots keeps others.
void restart(MeshFront& front) noexcept;

/// Sets the margin beyond the nearest triangles, which lasts for several steps.
/// @param step from `follow`. @param squared_distance of the nearest known so far.
void setMargin(double step, double squared_distance, MeshFront& front) noexcept;

/// The squared distance up to which triangles are measured, for that of the nearest ones.
double squaredReach(double squared_distance, const MeshFront& front) noexcept;

/// Keeps a pair, or leaves it to `cover`.
void keep(const FrontEntry& entry, const MovingBounds& moving, MeshFront& front) noexcept;

/// Replaces bound, direction and children of a kept pair.
void renew(std::uint32_t at, const FrontEntry& entry, MeshFront& front) noexcept;

/// Reads a kept pair with its current bound.
FrontEntry entryAt(std::uint32_t at, const MeshFront& front) noexcept;

/// Removes a pair; the last one takes its place.
void drop(std::uint32_t at, MeshFront& front) noexcept;

/// Packs a direction of any length as three numbers of ten bits, in shares of the length. 0: none.
std::uint32_t packed(const Eigen::Vector3d& direction) noexcept;

/// Unpacks a direction, within half a bit in each coordinate, so not of unit length.
Eigen::Vector3d directionOf(std::uint32_t packed) noexcept;

/// Chooses the likely direction along which the child nearest to the other bound is farthest from
/// it. Returns it packed.
/// @param children a bit for each child that is meant, at least one.
/// @param resting_from_node turns directions from the children's frame to that of MeshFront.
std::uint32_t directionFor(const OpenedPair& opened, std::uint32_t children,
                           const Eigen::Matrix3d& resting_from_node) noexcept;

/// [m] How far the other bound lies beyond each child along a packed direction, rounded down.
std::array<float, MeshTreeNode::kWidth> gapsAlong(
    std::uint32_t direction, const OpenedPair& opened,
    const Eigen::Matrix3d& resting_from_node) noexcept;

}  // namespace collision_monitor
