// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <limits>

#include "pipeline/states/check_states.h"

namespace collision_monitor {

/// The answers for a block of states. Truths are 1 and 0.
struct StatesBlock {
  StateNumber distance;  ///< [m] of `pair`; infinity if there is none
  StateNumber pair;      ///< a PairId
  StateNumber is_contact;
  StateNumber is_warning;
  StateNumber is_unknown;  ///< a pose is not finite
};

/// Writes the same vector for every state.
void fillAll(const Eigen::Vector3d& v, StateNumber (&numbers)[3]) noexcept;

/// The same pose in every state, for what no joint moves.
StatePose everywhere(const Pose& pose) noexcept;

/// Reads a block of states from `first` on, from positions as in checkStates. Repeats the last
/// state to fill the block.
void fillVariables(const JointPositions& positions, std::size_t first, StatesWork& work) noexcept;

/// The same of the states in `work.placed`: at least one, at most kStateCount.
void fillPlaced(const JointPositions& positions, StatesWork& work) noexcept;

/// How many states the positions hold.
std::size_t countStates(const JointPositions& positions, const StatesWork& work) noexcept;

/// The answer by enclosing shapes in one state of a judged block.
StateCheck checkOf(const CycleSetup& setup, const StatesBlock& block, std::size_t lane) noexcept;

/// Turns answers into unknown, unless they are in contact, if a pair has an unknown relative pose.
void addUnknown(const StatesWork& work, std::vector<StateCheck>& checks) noexcept;

/// Places frames and bodies for the variables in `work`.
void placeStates(const CycleSetup& setup, StatesWork& work) noexcept;

/// Places bodies alone.
/// @pre frames are placed.
void placeBodies(const CycleSetup& setup, StatesWork& work) noexcept;

/// @pre the states are placed.
void judgeBlock(const CycleSetup& setup, StateQuestion question, const StatesWork& work,
                StatesBlock& block) noexcept;

/// The poses of all links in one placed state of the block.
void readLinkPoses(const StatesWork& work, std::size_t lane, std::vector<Pose>& world_from_link);

/// Marks what a query skips: a state, or a link pair in every state.
constexpr double kNotAsked = -std::numeric_limits<double>::infinity();
/// Marks a state for which only pairs that may be in contact are listed.
constexpr double kContactsAsked = -std::numeric_limits<double>::max();

/// Measures the nearest bodies of link pairs in each state.
/// @pre the states are placed.
/// @param nearest [m] by LinkPairIndex. In: distances beyond it are not needed. Out: the distance
/// if it is less; NaN if a pose is not finite.
void measureLinkPairs(const CycleSetup& setup, const StatesWork& work,
                      std::vector<StateNumber>& nearest) noexcept;

/// By state of a block.
using BlockChecks = std::array<StateCheck, kStateCount>;
using OpenStates = std::array<bool, kStateCount>;

/// Selects the pairs to list.
struct NearQuery {
  const StateNumber& asked;  ///< [m] by state: lists pairs within it; or kContactsAsked or
                             ///< kNotAsked
  std::size_t first;         ///< [first, last) of StatesRefinement::order
  std::size_t last;
  bool is_convex_only{false};  ///< only pairs of two convex elements
  /// One near pair of bodies, not the nearest, is enough for two elements where isExact.
  bool asks_any{false};
};

/// Places the balls of elements in the states of a new block.
/// @pre frames are placed.
void placeCenters(StatesWork& work) noexcept;

/// Lists pairs of bodies in StatesRefinement::near that are near in some states of one vector, from
/// `lane` on.
/// @pre balls are placed. Bodies are placed here when they are first needed.
/// @return how many states the vector holds: distances are given for these.
std::size_t listNear(const CycleSetup& setup, const NearQuery& query, std::size_t lane,
                     StatesWork& work) noexcept;

/// Judges asked states by enclosing shapes, for StateQuestion::nearest. The answer is that of
/// judgeBlock; balls spare most of the measuring.
/// @param asked kNotAsked, or any other number
/// @pre balls are placed. Bodies are placed here when they are first needed.
void judgeNearest(const CycleSetup& setup, const StateNumber& asked, StatesWork& work,
                  StatesBlock& block) noexcept;

/// Makes the boxes around elements: `box_of` and `outer_boxes`.
void addBoxes(const CycleSetup& setup, const StatesWork& work, StatesRefinement& refinement);

/// Makes what checkStatesExactly needs beyond enclosing shapes.
StatesRefinement makeStatesRefinement(const CycleSetup& setup, const StatesWork& work);

/// Finds by geometries which states of the block are in contact, and their nearest pairs.
/// @pre balls are placed.
/// @param open by state: the states to search. Closes states in contact and writes their `checks`.
void settleContacts(const CycleSetup& setup, StatesWork& work, OpenStates& open,
                    BlockChecks& checks) noexcept;

/// Finds by geometries which open states of the block are in contact.
/// @pre balls are placed.
void refineContacts(const CycleSetup& setup, const OpenStates& open, StatesWork& work,
                    BlockChecks& checks) noexcept;

/// Finds by geometries the nearest pairs of open states of the block. States in contact are settled
/// before.
/// @pre balls are placed.
/// @param checks in: the answers by enclosing shapes
void refineNearest(const CycleSetup& setup, const OpenStates& open, StatesWork& work,
                   BlockChecks& checks) noexcept;

/// The distance of a pair of bodies in state `lane` by the plain twin, where the kernel is not
/// sure.
double plainStateDistance(const CycleSetup& setup, const StatesWork& work, const StatePair& pair,
                          std::size_t lane) noexcept;

}  // namespace collision_monitor
