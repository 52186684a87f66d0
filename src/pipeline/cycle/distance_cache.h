// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/cycle/cycle_buffers.h"

/// Earlier distances, kept as lower bounds while bodies move.
namespace collision_monitor {

/// Whether both bodies are the only ones of their elements and one of the two links has several, as
/// where links are many convex parts.
/// @param pair a BodyPair or another type with both
template <class Pair>
bool areLone(const DistanceCache& cache, const Pair& pair) noexcept {
  const unsigned char a = cache.lone[index(pair.a)];
  const unsigned char b = cache.lone[index(pair.b)];
  return (a & b & kLone) != 0 && ((a | b) & kOfSeveral) != 0;
}

/// [m] How far the links of two bodies have moved.
/// @param pair an ElementsPlace or a BodyPair
template <class Pair>
double travelOfLinks(const DistanceCache& cache, const Pair& pair) noexcept {
  return cache.travels[index(pair.a)].of_link_all + cache.travels[index(pair.b)].of_link_all;
}

/// [m] How far the links of two bodies have moved between the last two times that travel was added
/// up.
/// @param pair an ElementsPlace or a BodyPair
template <class Pair>
double stepOfLinks(const DistanceCache& cache, const Pair& pair) noexcept {
  return cache.travels[index(pair.a)].of_link + cache.travels[index(pair.b)].of_link;
}

/// Stores a lower bound of the distance in the cache.
inline void rememberDistance(double distance, const BodyPair& pair, PairId id,
                             DistanceCache& cache) noexcept {
  cache.distances[index(id)] =
      distance + (cache.travels[index(pair.a)].all + cache.travels[index(pair.b)].all);
}

/// Makes an empty cache.
DistanceCache makeDistanceCache(const CycleSetup& setup);

/// Resets `nearest` for the distances of this cycle.
void forgetNearest(DistanceCache& cache) noexcept;

/// Resets `nearest_of_links`.
void forgetNearestOfLinks(DistanceCache& cache) noexcept;

/// Adds up the travel of bodies, so that cached distances stay lower bounds. Forgets the cache if a
/// link is known that was not known the last time, or was in another part then.
/// @pre bodies are placed and looked ahead for; motions are found.
void accumulateTravel(const CycleSetup& setup, const LinkPoses& poses,
                      CycleBuffers& buffers) noexcept;

}  // namespace collision_monitor
