// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <limits>

#include "pipeline/states/check_states.h"

namespace collision_monitor {

/// What a block of states was found to be. Truths are 1 and 0.
struct StatesBlock {
  StateNumber distance;  ///< [m] of `pair`; infinite where there is none
  StateNumber pair;      ///< a PairId
  StateNumber is_contact;
  StateNumber is_warning;
  StateNumber is_unknown;  ///< a pose is not finite
};

/// The states from `first` on, as many as a block holds, of positions as those of checkStates;
/// behind the last one it is repeated.
void fillVariables(const JointPositions& positions, std::size_t first, StatesWork& work) noexcept;

/// Places frames and bodies of the states whose variables stand in `work`.
void placeStates(const CycleSetup& setup, StatesWork& work) noexcept;

/// @pre the states are placed.
void judgeBlock(const CycleSetup& setup, StateQuestion question, const StatesWork& work,
                StatesBlock& block) noexcept;

/// Poses of all links in one state of the block that was placed.
void readLinkPoses(const StatesWork& work, std::size_t lane, std::vector<Pose>& world_from_link);

/// Of a pair that measureLinkPairs is to leave out, in every state.
constexpr double kNotAsked = -std::numeric_limits<double>::infinity();
/// Of a state in which pairs are near that may be in contact, whatever their distance is then.
constexpr double kContactsAsked = -std::numeric_limits<double>::max();

/// Distances of the nearest bodies of pairs of links in each state.
/// @pre the states are placed.
/// @param nearest [m] by LinkPairIndex. Before: how far is asked for. Then: the distance, where it
/// is less than that; NaN where a pose is not finite.
void measureLinkPairs(const CycleSetup& setup, const StatesWork& work,
                      std::vector<StateNumber>& nearest) noexcept;

/// By state of a block.
using BlockChecks = std::array<StateCheck, kStateCount>;
using OpenStates = std::array<bool, kStateCount>;

/// Which pairs are listed.
struct NearQuery {
  const StateNumber& asked;  ///< [m] by state: how far; kContactsAsked or kNotAsked
  std::size_t first;         ///< those pairs of elements of StatesRefinement::order
  std::size_t last;
  bool is_convex_only{false};  ///< of those, pairs of convex elements alone
};

/// Places the balls about elements in the states of the block.
void placeCenters(StatesWork& work) noexcept;

/// Lists pairs of bodies that are near in some states, those of one vector from `lane` on, in
/// StatesRefinement::near.
/// @pre the states are placed, and the balls are.
/// @return how many states that were: of them distances are told.
std::size_t listNear(const CycleSetup& setup, const NearQuery& query, std::size_t lane,
                     StatesWork& work) noexcept;

/// What checkStatesExactly needs beside what enclosing shapes do.
StatesRefinement makeStatesRefinement(const CycleSetup& setup, const StatesWork& work);

/// Asks the geometries which states of the block are in contact, and of those for the nearest pair.
/// @pre the states are placed, and the balls are.
/// @param open  by state: these are asked. Those in contact are closed, and `checks` tells of them.
void settleContacts(const CycleSetup& setup, StatesWork& work, OpenStates& open,
                    BlockChecks& checks) noexcept;

/// Judges those states of the block by the geometries that enclosing shapes leave open. Of
/// StateQuestion::nearest without those in contact.
/// @pre the states are placed, and the balls are.
/// @param open  by state
/// @param checks  of the states: what enclosing shapes say, then what the geometries do
void refineStates(const CycleSetup& setup, StateQuestion question, const OpenStates& open,
                  StatesWork& work, BlockChecks& checks) noexcept;

/// Where the kernel is not sure: state `lane` of a pair of bodies by the plain twin.
double plainStateDistance(const CycleSetup& setup, const StatesWork& work, const StatePair& pair,
                          std::size_t lane) noexcept;

}  // namespace collision_monitor
