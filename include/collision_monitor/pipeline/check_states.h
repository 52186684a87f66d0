// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "collision_monitor/model/state_kinematics.h"
#include "collision_monitor/pipeline/run_cycle.h"

/// Many states of the robots at once: trajectories, samples, requests.
namespace collision_monitor {

enum class StateQuestion : unsigned char {
  contact,  ///< is anything in contact? A state's search ends at the first pair that is
  nearest,  ///< the nearest pair, and the worst verdict
};

/// The answer for one state.
struct StateCheck {
  /// For StateQuestion::contact: contact, clear or unknown. Unknown where a joint variable is not
  /// finite, never clear.
  Verdict verdict{Verdict::unknown};
  Quality quality{Quality::unknown};  ///< of the distance
  bool has_pair{false};               ///< false: clear of contact, unknown, or nothing is checked
  PairId pair{};
  double distance{0.0};  ///< [m] of `pair`
};

/// Two bodies of the table as the kernels take them: the simpler core first.
struct StatePair {
  std::uint32_t a{0};
  std::uint32_t b{0};
  double bounding_radii{0.0};  ///< [m] of both
  double contact_distance{0.0};
  double warning_distance{0.0};
  bool is_apart{false};  ///< how its links stand to each other is not known
};

/// What checkStates works with, made once for a set-up and where its robots stand.
struct StatesWork {
  KinematicsPlan plan;
  std::vector<LinkPlace> body_places;  ///< by BodyId: frame_from_link is frame_from_body here
  std::vector<StatePair> pairs;        ///< by PairId
  ContactDistances contact_distances;
  std::vector<StateNumber> variables;  ///< of the states at hand
  std::vector<StatePose> frames;
  std::vector<StatePose> bodies;  ///< by BodyId
  BodyRows rows;                  ///< of a state that is alone
  LinkPoses poses;                ///< these two of a state that is refined; parts are of all states
  CycleBuffers buffers;
  bool is_split{false};  ///< a pair is apart: no state is clear
};

/// Roots, fixed joints, and joints whose first variable does not move, stand as in `poses`; fixed
/// joints that are not known there as in the model. Roots of parts that float are not known.
/// @param moves by variable
StandingPoses standingAs(const RobotModel& model, const LinkPoses& poses,
                         const std::vector<bool>& moves);

/// Links behind a root or joint that is not known stand in a part of their own: pairs of its links
/// are judged as all others, and those across two parts are unknown in every state.
StatesWork makeStatesWork(const CycleSetup& setup, const StandingPoses& standing);

/// Judges states by their enclosing shapes: each `variable_count` numbers of `positions` in a row
/// are one state; a model without variables has one. Limits have no hysteresis here. Shapes about
/// an element that overlap are in contact even if contact_distance allows some depth, for that of
/// the element may be more. Does not allocate when `checks` has room.
///
/// Error: as distanceBetween; the same bytes with every instruction set.
/// @pre positions.size() is a multiple of the model's variable_count.
void checkStates(const CycleSetup& setup, const JointPositions& positions, StateQuestion question,
                 StatesWork& work, std::vector<StateCheck>& checks);

/// The same, and where enclosing shapes that are not the geometry itself come as near as a
/// warning, the geometries decide, as in a cycle without a budget.
void checkStatesExactly(const CycleSetup& setup, const JointPositions& positions,
                        StateQuestion question, StatesWork& work, std::vector<StateCheck>& checks);

}  // namespace collision_monitor
