// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "model/kinematics/state_kinematics.h"
#include "pipeline/cycle/cycle_buffers.h"

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

/// A pair of bodies that is near in some of a block's states.
struct NearInStates {
  std::uint32_t pair{0};                     ///< a PairId
  std::array<double, kStateCount> distance;  ///< [m] by state; infinite where it is not near
};

/// What is known of two elements in the state at hand.
struct ElementsInState {
  ElementPairIndex elements{0};
  std::uint32_t bodies{0};   ///< PairId of the nearest
  double bound{0.0};         ///< [m] their distance
  std::uint64_t touched{0};  ///< of StatesRefinement::touched
};

/// Two elements, and the pairs of bodies that stand for them.
struct StateElementPair {
  std::uint32_t a{0};  ///< ElementIds
  std::uint32_t b{0};
  double radii{0.0};             ///< [m] of the balls about both
  double contact_distance{0.0};  ///< [m] of their bodies, at most
  std::uint32_t first{0};        ///< into StatesRefinement::body_pairs
  std::uint32_t last{0};
  bool are_convex{false};
};

/// A point in each state.
struct StatePoint {
  StateNumber of[3];
};

/// What checkStatesExactly works with beside that.
struct StatesRefinement {
  std::vector<LinkPlace> places;  ///< by ElementId: frame_from_link is frame_from_element
  std::vector<Ball> balls;        ///< by ElementId: about it and its padding, in its frame
  std::vector<StateElementPair> element_pairs;  ///< by ElementPairIndex; none that are apart
  std::vector<std::uint32_t> body_pairs;        ///< PairIds, in order of element pair
  std::vector<StatePoint> centers;              ///< by ElementId: of the balls
  std::vector<Pose> world_from_element;         ///< by ElementId, in the state at hand
  std::vector<std::uint64_t> placed_in;         ///< by ElementId: the state for which it is that
  std::uint64_t state{0};                       ///< counts states
  RefineStore memory;
  std::unique_ptr<RefineScratch> scratch;
  std::vector<NearInStates> near;
  std::vector<std::uint32_t> place_of;  ///< by ElementPairIndex: into `pairs`, or kNone
  std::vector<ElementsInState> pairs;   ///< in the state at hand
  std::vector<std::uint64_t> touched;   ///< by ElementPairIndex: the last state with a contact
  std::vector<ElementPairIndex> order;  ///< those that were in contact last come first
  bool has_geometries{false};           ///< behind some enclosing shapes
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
  LinkPoses poses;                ///< which links are known, and in which part, in all states
  StatesRefinement refinement;
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
/// warning, the geometries decide, with the verdicts of a cycle without a budget.
///
/// Each question takes the cheapest search that answers it: whether geometries touch is no question
/// of their distance, and how deep those are that overlap is not asked. Then the distance is that
/// of what was found (Quality::estimate), 0 or the depth of inner shapes.
void checkStatesExactly(const CycleSetup& setup, const JointPositions& positions,
                        StateQuestion question, StatesWork& work, std::vector<StateCheck>& checks);

}  // namespace collision_monitor
