// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "narrow_phase/mesh/mesh_search.h"

/// What one search leaves for the next, as two things move: see MeshFront. Lengths in metres.
namespace collision_monitor {

/// Two things that a front is about, and the balls that hold them, each in its own frame.
struct FollowedPair {
  const Pose& a_from_b;
  Eigen::Vector3d center_of_a;
  double radius_of_a;
  Eigen::Vector3d center_of_b;
  double radius_of_b;
  double rounding;  ///< [m] as MeshPair::rounding
};

/// Brings the front to where the two are now.
/// @return how far any point of one may have come, seen from the other, since the last query;
/// infinity if there was none.
double follow(const FollowedPair& pair, MeshFront& front) noexcept;

/// [m] Pairs whose MeshFront::due is less may be nearer than the goal.
float dueNow(double squared_goal, const MeshFront& front) noexcept;

/// True when all that was not kept is no nearer than the goal, and no more of what was kept is due
/// than the search from the roots looked at.
bool covers(double squared_goal, const MeshFront& front) noexcept;

/// Forgets all pairs: a search from the roots keeps others.
void restart(MeshFront& front) noexcept;

/// Triangles are measured up to the nearest and a margin, which is to last for several steps.
/// @param step what `follow` said. @param squared_distance of the nearest known so far.
void setMargin(double step, double squared_distance, MeshFront& front) noexcept;

/// The square of how far triangles are worth measuring, with the nearest as far as given.
double squaredReach(double squared_distance, const MeshFront& front) noexcept;

/// As MeshFront::due of what is so far away now.
float dueOf(double squared_bound, const MeshFront& front) noexcept;

/// [m^2] And back: as far as it was known, less the motion since.
float boundDue(float due, const MeshFront& front) noexcept;

/// Keeps a pair that is at least as far away as given, or leaves it to `cover`.
/// @param detail as MeshFront::Kept.
void keep(std::uint32_t a, std::uint32_t b, double squared_bound, std::uint32_t detail,
          MeshFront& front) noexcept;

/// Keeps a pair no longer: the last one takes its place.
void drop(std::uint32_t at, MeshFront& front) noexcept;

/// A direction as MeshFront::Kept::detail.
std::uint32_t packed(const Eigen::Vector3d& direction) noexcept;

/// And back, of any length.
Eigen::Vector3d directionOf(std::uint32_t packed) noexcept;

}  // namespace collision_monitor
