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

/// Whether two geometries that touch are elements in contact, whatever their bodies say.
bool isExact(const CycleSetup& setup, ElementPairIndex pair) noexcept;

/// Lists the pairs of elements of StatesRefinement::near, each with its nearest bodies.
/// @param place of the state in its vector
/// @return false if a pose is not finite.
bool listElements(const StateSearch& state, std::size_t place) noexcept;

void forgetElements(StatesRefinement& refinement) noexcept;

/// Finds the first listed pair that is in contact.
bool findContact(const StateSearch& state, StateCheck& check) noexcept;

/// Finds the nearest listed pair and the worst verdict.
/// @param best what is known before: a contact, or that there is none
void findNearest(const StateSearch& state, StateCheck& best) noexcept;

}  // namespace collision_monitor
