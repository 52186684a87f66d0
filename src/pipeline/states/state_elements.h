// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/states/states_block.h"

/// The pairs of elements that are near in one state of a block.
namespace collision_monitor {

/// One state of the block.
struct StateSearch {
  const CycleSetup& setup;
  StatesWork& work;
  std::size_t lane;

  StatesRefinement& refinement() const noexcept { return work.refinement; }
};

/// Whether the bodies of two elements are all that is asked of them.
bool areBodies(const CycleSetup& setup, ElementPairIndex pair) noexcept;

/// Lists pairs of elements with their nearest bodies, of StatesRefinement::near.
/// @param place  of the state in the vector that was listed
/// @return false where a pose is not finite.
bool listElements(const StateSearch& state, std::size_t place) noexcept;

void forgetElements(StatesRefinement& refinement) noexcept;

/// The first listed pair that is in contact, if one is.
bool findContact(const StateSearch& state, StateCheck& check) noexcept;

/// The nearest listed pair, and the worst verdict.
/// @param best  what is known: a contact that was found, or that none was
void findNearest(const StateSearch& state, StateCheck& best) noexcept;

}  // namespace collision_monitor
