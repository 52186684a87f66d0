// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "narrow_phase/mesh/mesh_search.h"

/// What one search leaves for the next, as the meshes move: see MeshFront. Lengths in metres.
namespace collision_monitor {

/// Brings the front to where the meshes are now.
/// @return how far any point of one may have come, seen from the other, since the last query;
/// infinity if there was none.
double follow(const MeshPair& pair, MeshFront& front) noexcept;

/// True when all that was not kept is at least this far away.
bool covers(const MeshFront& front, double squared_distance) noexcept;

/// Bounds anew the pairs that may have come nearer than the goal, and lets those wait that have,
/// the nearest on top; keeps the rest. What the budget leaves waits with the bound that it had.
struct TakenPairs {
  double squared_left;   ///< [m^2] of a lower bound of all that are kept or were never
  std::uint32_t visits;  ///< for what it took
};
TakenPairs takeNearer(const MeshPair& pair, double squared_goal, std::uint32_t visit_budget,
                      MeshFront& front, WaitingPairs& waiting) noexcept;

/// Forgets all pairs: a search from the roots keeps others.
/// @param step what `follow` said: the margin is to last for several of them.
/// @param squared_distance of the nearest known so far.
void restart(double step, double squared_distance, MeshFront& front) noexcept;

/// The square of how far pairs are worth keeping, with the nearest as far as given.
double squaredReach(double squared_distance, MeshFront& front) noexcept;

/// Keeps a pair that is at least as far away as given.
void keep(std::uint32_t a, std::uint32_t b, double squared_bound, MeshFront& front) noexcept;

}  // namespace collision_monitor
