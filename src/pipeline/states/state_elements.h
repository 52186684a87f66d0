// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/states/states_block.h"

/// The pairs of elements that are near in one state of a block.
namespace collision_monitor {

/// One state of a block.
struct StateSearch {
  const CycleSetup& setup;
  StatesWork& work;
  std::size_t lane;

  StatesRefinement& refinement() const noexcept { return work.refinement; }
};

/// Moves a pair to the front. @pre `order` has it
void putFirst(ElementPairIndex pair, std::vector<OrderedPair>& order) noexcept;

/// Whether two elements are themselves bodies: nothing to refine.
bool areBodies(const CycleSetup& setup, ElementPairIndex pair) noexcept;

/// Whether the distance of two elements is that of their geometries: no bound of bodies is better.
bool areMeasured(const CycleSetup& setup, ElementPairIndex pair) noexcept;

/// Whether the geometries alone decide about contact: they are known exactly, and contact begins
/// where they touch.
bool isExact(const CycleSetup& setup, ElementPairIndex pair) noexcept;

/// Lists the pairs of elements of StatesRefinement::near, each with its nearest bodies.
/// @param place of the state in its vector
/// @return false if a pose is not finite.
bool listElements(const StateSearch& state, std::size_t place) noexcept;

void forgetElements(StatesRefinement& refinement) noexcept;

/// Finds the first listed pair that is in contact.
bool findContact(const StateSearch& state, StateCheck& check) noexcept;

/// Finds the nearest listed pair and the worst verdict.
/// @param best what is known before: a contact, that there is none, or measureConvex of a pair
void findNearest(const StateSearch& state, StateCheck& best) noexcept;

/// Measures the elements of two bodies if both are convex: an upper bound of the nearest distance
/// that costs little.
/// @param bodies the answer by enclosing shapes
/// @return no pair if they are not convex, or not exact
StateCheck measureConvex(const StateSearch& state, const StateCheck& bodies) noexcept;

}  // namespace collision_monitor
