// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "model/kinematics/state_kinematics.h"
#include "pipeline/cycle/cycle_buffers.h"

/// Judges many states of the robots at once: of trajectories, samples, requests.
namespace collision_monitor {

/// The answer for one state.
struct StateCheck {
  /// For StateQuestion::contact: contact, clear or unknown. Unknown, never clear, if a joint
  /// variable is not finite.
  Verdict verdict{Verdict::unknown};
  Quality quality{Quality::unknown};  ///< of the distance
  bool has_pair{false};               ///< false: no contact, unknown, or no pair is checked
  PairId pair{};
  double distance{0.0};  ///< [m] of `pair`
};

/// Two bodies of the table in the order of the kernels: the simpler core first.
struct StatePair {
  std::uint32_t a{0};
  std::uint32_t b{0};
  double bounding_radii{0.0};  ///< [m] sum of both
  double contact_distance{0.0};
  double warning_distance{0.0};
  bool is_apart{false};  ///< the relative pose of its links is unknown
};

/// A pair of bodies that is near in some states of a block.
struct NearInStates {
  std::uint32_t pair{0};                     ///< a PairId
  std::array<double, kStateCount> distance;  ///< [m] by state; infinity where it is not near
};

/// What is known of two elements in the current state.
struct ElementsInState {
  ElementPairIndex elements{0};
  std::uint32_t bodies{0};   ///< PairId of the nearest bodies
  double bound{0.0};         ///< [m] a lower bound of their distance
  std::uint64_t touched{0};  ///< as in StatesRefinement::touched
  bool is_raised{false};     ///< the hulls have been asked for a larger bound
};

/// Two elements and their pairs of bodies.
struct StateElementPair {
  std::uint32_t a{0};  ///< ElementIds
  std::uint32_t b{0};
  double radii{0.0};       ///< [m] sum of the radii of their balls
  double body_radii{0.0};  ///< [m] as `radii`, of balls about the same centers that hold the bodies
  double contact_distance{0.0};  ///< [m] the largest of their bodies
  double warning_distance{0.0};  ///< [m] of their links
  std::uint32_t first{0};        ///< into StatesRefinement::body_pairs
  std::uint32_t last{0};
  bool are_convex{false};
  std::uint32_t ball{0};      ///< ElementId of the one with the smaller ball
  std::uint32_t box{0};       ///< StatesRefinement::box_of of the other one
  std::uint32_t ball_box{0};  ///< StatesRefinement::box_of of `ball`
  bool has_many{false};       ///< they have several pairs of bodies, and each has a box
};

/// Two elements in the order of a search, with what mostly parts them.
struct OrderedPair {
  ElementPairIndex elements{0};
  std::uint32_t a{0};  ///< ElementIds
  std::uint32_t b{0};
  double squared_contact{0.0};  ///< [m^2] square of the sum of both radii and `contact_distance`
};

/// A box around all bodies of an element.
struct OuterBox {
  Core core;
  LinkPlace place;             ///< frame_from_link is frame_from_box here
  StatePose pose{};            ///< in the states of a block
  std::uint64_t placed_in{0};  ///< the last block that placed it
};

/// A point in each state.
struct StatePoint {
  StateNumber of[3];
};

/// What checkStatesExactly needs in addition.
struct StatesRefinement {
  std::vector<LinkPlace> places;  ///< by ElementId: frame_from_link is frame_from_element
  std::vector<Ball> balls;        ///< by ElementId: around the padded element, element frame
  std::vector<StateElementPair> element_pairs;  ///< by ElementPairIndex; of no bodies if apart
  std::vector<std::uint32_t> body_pairs;        ///< PairIds, in order of element pair
  std::vector<StatePoint> centers;              ///< by ElementId: centers of the balls
  std::uint64_t block{0};                       ///< counter of blocks
  std::vector<std::uint64_t> body_placed_in;    ///< by BodyId: the last block that placed it
  /// By ElementId. If its one body is a box: the BodyId. If it has several bodies: the number of
  /// all bodies plus an index into `outer_boxes`. Else kNone.
  std::vector<std::uint32_t> box_of;
  std::vector<OuterBox> outer_boxes;
  std::vector<Pose> world_from_element;  ///< by ElementId, in the current state
  std::vector<std::uint64_t> placed_in;  ///< by ElementId: the state of that pose
  std::uint64_t state{0};                ///< counter of states
  RefineStore memory;
  std::unique_ptr<RefineScratch> scratch;
  std::vector<NearInStates> near;
  std::uint8_t have_near{0};  ///< a bit for each state of the vector: it has some of `near`
  std::vector<std::uint32_t> place_of;     ///< by ElementPairIndex: index into `pairs`, or kNone
  std::vector<ElementsInState> pairs;      ///< in the current state
  std::vector<std::uint64_t> touched;      ///< by ElementPairIndex: the last state with a contact
  std::vector<OrderedPair> order;          ///< pairs last in contact come first
  std::vector<OrderedPair> nearest_order;  ///< pairs whose bodies were last the nearest come first
  bool has_geometries{false};              ///< some enclosing shapes are not their geometry
  /// Each state is searched as if it were the first: answers then depend on no other state, to the
  /// last bit. `order` stays as it is.
  bool is_independent{false};
  std::vector<std::uint64_t> searched_in;  ///< by ElementPairIndex: the state of its memory
};

/// How many states checkStatesExactly searches together. Those that a cheap search leaves open fill
/// new blocks for the next.
constexpr std::size_t kOpenStates = 256;

/// What a search of states needs; made once for a set-up and the standing poses of its robots.
struct StatesWork {
  KinematicsPlan plan;
  std::vector<LinkPlace> body_places;  ///< by BodyId: frame_from_link is frame_from_body here
  std::vector<StatePair> pairs;        ///< by PairId
  ContactDistances contact_distances;
  std::vector<StateNumber> variables;  ///< of the current states
  std::vector<StatePose> frames;
  std::vector<StatePose> bodies;  ///< by BodyId
  BodyRows rows;                  ///< of a state that is judged alone
  LinkPoses poses;  ///< which links are known, and in which part; the same in all states
  StatesRefinement refinement;
  std::vector<std::uint32_t> open;    ///< states that checkStatesExactly has not answered yet
  std::vector<std::uint32_t> placed;  ///< the states of its last block
  bool is_split{false};               ///< a pair has an unknown relative pose: no state is clear
};

/// Roots, fixed joints, and joints whose first variable does not move, keep their pose in `poses`.
/// Fixed joints that are unknown there keep their pose in the model. Roots of parts that float are
/// unknown.
/// @param moves by variable
StandingPoses standingAs(const RobotModel& model, const LinkPoses& poses,
                         const std::vector<bool>& moves);

/// Links behind an unknown root or joint form a part of their own. Pairs within it are judged as
/// all others; pairs of two parts are unknown in every state.
StatesWork makeStatesWork(const CycleSetup& setup, const StandingPoses& standing);

/// The same for enclosing shapes alone: not for checkStatesExactly.
StatesWork makeShapeStatesWork(const CycleSetup& setup, const StandingPoses& standing);

/// Judges states by enclosing shapes. Each `variable_count` numbers of `positions` are one state; a
/// model without variables has one state. Limits have no hysteresis here. Overlapping shapes around
/// an element are in contact even if contact_distance allows some depth, since the element may be
/// deeper. Does not allocate if `checks` has room.
///
/// Error: as distanceBetween; the same bytes with every instruction set.
/// @pre positions.size() is a multiple of the model's variable_count.
void checkStates(const CycleSetup& setup, const JointPositions& positions, StateQuestion question,
                 StatesWork& work, std::vector<StateCheck>& checks);

/// As checkStates, but geometries decide where enclosing shapes that are not the geometry are
/// within the warning distance. Verdicts are those of a cycle without a budget. One differs: an
/// overlap whose depth is only bounded is a contact, even if contact_distance allows some depth.
///
/// Each question takes the cheapest search that answers it. A contact test needs no distance, and
/// overlaps get no depth: their distance is 0 or that of inner shapes, of Quality::estimate.
void checkStatesExactly(const CycleSetup& setup, const JointPositions& positions,
                        StateQuestion question, StatesWork& work, std::vector<StateCheck>& checks);

}  // namespace collision_monitor
