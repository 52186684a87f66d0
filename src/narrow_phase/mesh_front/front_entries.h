// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "narrow_phase/mesh/mesh_search.h"

/// What one search leaves for the next, as two things move: see MeshFront. Lengths in metres.
namespace collision_monitor {

/// A mesh that moves, seen from something that rests, and balls that hold both, each in its own
/// frame.
struct FollowedPair {
  const Pose& resting_from_moving;
  const MeshTree& moving;
  Eigen::Vector3d center_of_resting;
  double radius_of_resting;
  double side;      ///< 1: directions are from the resting to the moving one; -1: the other way
  double rounding;  ///< [m] as MeshPair::rounding
};

/// Which of two bounds moves.
struct MovingBounds {
  const MeshTree* tree{nullptr};
  bool is_a{false};
  double units_per_metre{0.0};  ///< of the coordinates in MeshFront::center
};

MovingBounds movingBounds(const MeshTree& tree, bool is_a) noexcept;

/// What is kept of a pair.
struct FrontEntry {
  MeshFront::Kept pair;
  double bound;             ///< [m]
  std::uint32_t direction;  ///< as MeshFront::direction
  std::uint32_t children;   ///< a bit for each child that is meant; 0: all
};

/// Brings the front to where the two are now.
/// @return how far any point of one may have come, seen from the other, since the last query;
/// infinity if there was none.
double follow(const FollowedPair& pair, MeshFront& front) noexcept;

/// A goal that bounds in single precision are below if they may be nearer.
float roundedUp(double goal) noexcept;

/// True when all that was not kept is no nearer than the goal, and no more of what was kept may be
/// nearer than the search from the roots looked at.
bool covers(double squared_goal, const MeshFront& front) noexcept;

/// The block of a pair, and its place there.
inline MeshFront::Block& blockOf(std::uint32_t at, const MeshFront& front) noexcept {
  return *front.blocks[at / MeshFront::kBlockSize];
}
inline std::size_t placeOf(std::uint32_t at) noexcept { return at % MeshFront::kBlockSize; }

/// Takes a block where it needs one. @return whether there is room for one more pair.
bool ensureRoom(MeshFront& front) noexcept;

/// Forgets all pairs: a search from the roots keeps others.
void restart(MeshFront& front) noexcept;

/// Triangles are measured up to the nearest and a margin, which is to last for several steps.
/// @param step what `follow` said. @param squared_distance of the nearest known so far.
void setMargin(double step, double squared_distance, MeshFront& front) noexcept;

/// The square of how far triangles are worth measuring, with the nearest as far as given.
double squaredReach(double squared_distance, const MeshFront& front) noexcept;

/// Keeps a pair, or leaves it to `cover`.
void keep(const FrontEntry& entry, const MovingBounds& moving, MeshFront& front) noexcept;

/// Replaces what is kept of a pair, but for the pair itself.
void renew(std::uint32_t at, const FrontEntry& entry, MeshFront& front) noexcept;

/// As it was kept, with the bound of now.
FrontEntry entryAt(std::uint32_t at, const MeshFront& front) noexcept;

/// Keeps a pair no longer: the last one takes its place.
void drop(std::uint32_t at, MeshFront& front) noexcept;

/// A direction of any length: three numbers of ten bits, in shares of the length. 0: none.
std::uint32_t packed(const Eigen::Vector3d& direction) noexcept;

/// And back, within half a bit a coordinate, so not of unit length.
Eigen::Vector3d directionOf(std::uint32_t packed) noexcept;

/// The direction in which the child that is nearest to the other bound is farthest from it, of
/// those that are likely; packed.
/// @param children a bit for each that is meant, one at least.
/// @param resting_from_node turns directions from the children to those that MeshFront keeps.
std::uint32_t directionFor(const OpenedPair& opened, std::uint32_t children,
                           const Eigen::Matrix3d& resting_from_node) noexcept;

/// [m] How far the other bound lies beyond each child along a packed direction, rounded down.
std::array<float, MeshTreeNode::kWidth> gapsAlong(
    std::uint32_t direction, const OpenedPair& opened,
    const Eigen::Matrix3d& resting_from_node) noexcept;

}  // namespace collision_monitor
