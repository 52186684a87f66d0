// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/states/check_states.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "narrow_phase/simd/plain_twin.h"
#include "pipeline/blocks/contact_of_pairs.h"
#include "pipeline/cycle/place_bodies.h"
#include "pipeline/states/float_unknown.h"
#include "pipeline/states/states_block.h"

namespace collision_monitor {
namespace {

StatePair statePair(const CycleSetup& setup, std::size_t id) {
  const BodyPair& bodies = setup.table.pairs()[id];
  StatePair pair;
  pair.a = static_cast<std::uint32_t>(index(bodies.a));
  pair.b = static_cast<std::uint32_t>(index(bodies.b));
  pair.bounding_radii = setup.bodies[pair.a].bounding_radius + setup.bodies[pair.b].bounding_radius;
  pair.contact_distance = contactOfBodies(setup, idAt<PairId>(id));
  pair.warning_distance = limitsOf(setup, setup.link_pair_of[id]).warning_distance;
  if (setup.cores[pair.a].kind > setup.cores[pair.b].kind) {
    std::swap(pair.a, pair.b);
  }
  return pair;
}

/// The same pose in every state, for a body that no joint moves.
StatePose everywhere(const Pose& pose) {
  StatePose state_pose;
  fillAll(pose.translation, state_pose.translation);
  fillAll(pose.rotation.col(0), state_pose.axis_x);
  fillAll(pose.rotation.col(1), state_pose.axis_y);
  fillAll(pose.rotation.col(2), state_pose.axis_z);
  return state_pose;
}

/// A body's pose; of points and segments only what their kind needs is placed.
Pose bodyPose(CoreKind kind, const StatePose& pose, std::size_t lane) noexcept {
  const Pose one = poseOf(pose, lane);
  return kind == CoreKind::box       ? one
         : kind == CoreKind::segment ? poseAlong(one.rotation.col(2), one.translation)
                                     : Pose{Eigen::Matrix3d::Identity(), one.translation};
}

std::size_t countStates(const JointPositions& positions, const StatesWork& work) noexcept {
  const std::size_t variables = work.plan.variable_count;
  return variables == 0 ? 1 : positions.size() / variables;
}

bool isFiniteState(const StatesWork& work, std::size_t lane) noexcept {
  return std::all_of(work.variables.begin(), work.variables.end(),
                     [&](const StateNumber& variable) { return std::isfinite(variable.of[lane]); });
}

StateCheck checkOf(const CycleSetup& setup, const StatesBlock& block, std::size_t lane) noexcept {
  StateCheck check;
  check.distance = block.distance.of[lane];
  check.has_pair = check.distance < std::numeric_limits<double>::infinity();
  check.pair = idAt<PairId>(static_cast<std::size_t>(block.pair.of[lane]));
  if (check.has_pair) {
    const BodyPair& pair = setup.table[check.pair];
    check.quality = setup.bodies[index(pair.a)].is_exact && setup.bodies[index(pair.b)].is_exact
                        ? Quality::exact
                        : Quality::lower_bound;
  }
  check.verdict = block.is_contact.of[lane] > 0.0   ? Verdict::contact
                  : block.is_unknown.of[lane] > 0.0 ? Verdict::unknown
                  : block.is_warning.of[lane] > 0.0 ? Verdict::warning
                                                    : Verdict::clear;
  return check;
}

/// Finds a contact in state 0 alone, faster than in all states of the block.
void judgeAlone(const CycleSetup& setup, StatesWork& work, StatesBlock& block) noexcept {
  for (std::size_t i = 0; i < work.bodies.size(); ++i) {
    writeBody(setup.cores[i].kind, poseOf(work.bodies[i], 0), setup.blocks.slot_of[i], work.rows);
  }
  FoundContact found;
  findContact(setup.blocks, work.rows, work.contact_distances, found);
  block.distance.of[0] = found.contact.distance;
  block.pair.of[0] = static_cast<double>(index(found.contact.pair));
  const bool is_contact = found.contact.distance < std::numeric_limits<double>::infinity();
  block.is_contact.of[0] = is_contact ? 1.0 : 0.0;
  block.is_unknown.of[0] = found.has_unknown ? 1.0 : 0.0;
  block.is_warning.of[0] = 0.0;
}

/// Marks pairs of two parts, which are never in contact.
void partPairs(const CycleSetup& setup, StatesWork& work) {
  for (std::size_t i = 0; i < work.pairs.size(); ++i) {
    const CheckedLinkPair& links = setup.checked[setup.link_pair_of[i]];
    if (!isJoined(work.poses, links.a, links.b)) {
      work.pairs[i].is_apart = true;
      work.contact_distances.of_pair[i] = -std::numeric_limits<double>::infinity();
      work.is_split = true;
    }
  }
}

void addUnknown(const StatesWork& work, std::vector<StateCheck>& checks) noexcept {
  for (StateCheck& check : checks) {
    check.verdict = work.is_split ? std::max(check.verdict, Verdict::unknown) : check.verdict;
  }
}

/// Whether geometries must decide. The nearest bodies may not be the ones in contact, nor those
/// that are a warning by limits of their own.
bool isOpen(const CycleSetup& setup, const StateCheck& check) noexcept {
  const bool is_contact = check.verdict == Verdict::contact;
  const bool is_near = is_contact || check.verdict == Verdict::warning;
  if (!is_near || check.quality != Quality::exact) {
    return is_near;
  }
  const std::uint32_t link_pair = setup.link_pair_of[index(check.pair)];
  return check.distance > (is_contact ? contactOfBodies(setup, check.pair)
                                      : limitsOf(setup, link_pair).warning_distance);
}

/// Judges by enclosing shapes. @param count states in the block
void judgeShapes(const CycleSetup& setup, StateQuestion question, std::size_t count,
                 StatesWork& work, BlockChecks& checks) noexcept {
  StatesBlock block;
  if (question == StateQuestion::contact && count == 1) {
    judgeAlone(setup, work, block);
  } else {
    judgeBlock(setup, question, work, block);
  }
  for (std::size_t lane = 0; lane < count; ++lane) {
    checks[lane] = isFiniteState(work, lane) ? checkOf(setup, block, lane) : StateCheck{};
  }
}

bool hasOpen(const OpenStates& open) noexcept {
  return std::any_of(open.begin(), open.end(), [](bool is_open) { return is_open; });
}

/// Judges open states by enclosing shapes. Those whose answer needs geometries stay open.
void judgeApart(const CycleSetup& setup, std::size_t count, StatesWork& work, OpenStates& open,
                BlockChecks& checks) noexcept {
  BlockChecks by_shapes;
  placeBodies(setup, work);
  judgeShapes(setup, StateQuestion::nearest, count, work, by_shapes);
  for (std::size_t lane = 0; lane < count; ++lane) {
    if (open[lane]) {
      checks[lane] = by_shapes[lane];
      open[lane] = isOpen(setup, checks[lane]);
    }
  }
}

/// Judges by geometries. For the nearest pair it searches contacts first, which settle most states
/// that have some; then it refines states that enclosing shapes leave open.
/// @pre frames are placed.
void judgeGeometries(const CycleSetup& setup, StateQuestion question, std::size_t count,
                     StatesWork& work, BlockChecks& checks) noexcept {
  OpenStates open{};
  for (std::size_t lane = 0; lane < count; ++lane) {
    checks[lane] = StateCheck();
    open[lane] = isFiniteState(work, lane);
  }
  placeCenters(work);
  if (question == StateQuestion::nearest) {
    if (work.refinement.has_geometries) {
      settleContacts(setup, work, open, checks);
    }
    if (hasOpen(open)) {
      judgeApart(setup, count, work, open, checks);
    }
  }
  if (hasOpen(open)) {
    refineStates(setup, question, open, work, checks);
  }
}

/// @param is_exact geometries decide
void judgeStates(const CycleSetup& setup, const JointPositions& positions, StateQuestion question,
                 bool is_exact, StatesWork& work, std::vector<StateCheck>& checks) {
  const std::size_t total = countStates(positions, work);
  checks.resize(total);
  BlockChecks of_block;
  for (std::size_t first = 0; first < total; first += kStateCount) {
    const std::size_t count = std::min(kStateCount, total - first);
    fillVariables(positions, first, work);
    placeFrames(work.plan, work.variables, work.frames);
    if (!is_exact) {
      placeBodies(setup, work);
    }
    (is_exact ? judgeGeometries : judgeShapes)(setup, question, count, work, of_block);
    std::copy_n(of_block.begin(), count, checks.begin() + static_cast<std::ptrdiff_t>(first));
  }
  addUnknown(work, checks);
}

}  // namespace

StatesWork makeStatesWork(const CycleSetup& setup, const StandingPoses& standing) {
  StatesWork work;
  work.poses = makeLinkPoses(setup.model);
  std::fill(work.poses.status.begin(), work.poses.status.end(), LinkStatus::known);
  work.plan = planKinematics(setup.model, floatUnknown(setup.model, standing, work.poses));
  for (const Body& body : setup.bodies) {
    LinkPlace place = work.plan.links[index(body.link)];
    place.frame_from_link = place.frame_from_link * body.link_from_body;
    work.body_places.push_back(place);
    work.bodies.push_back(everywhere(place.frame_from_link));
  }
  for (std::size_t i = 0; i < setup.table.size(); ++i) {
    work.pairs.push_back(statePair(setup, i));
  }
  work.contact_distances = contactDistancesOf(setup);
  work.rows = makeBodyPoses(setup).rows;
  work.variables.resize(work.plan.variable_count);
  work.frames.resize(work.plan.frames.size());
  partPairs(setup, work);
  work.refinement = makeStatesRefinement(setup, work);
  return work;
}

void fillAll(const Eigen::Vector3d& v, StateNumber (&numbers)[3]) noexcept {
  for (std::size_t k = 0; k < 3; ++k) {
    std::fill(std::begin(numbers[k].of), std::end(numbers[k].of), v[static_cast<Eigen::Index>(k)]);
  }
}

void fillVariables(const JointPositions& positions, std::size_t first, StatesWork& work) noexcept {
  const std::size_t variables = work.plan.variable_count;
  const std::size_t last = countStates(positions, work) - 1;
  for (std::size_t lane = 0; lane < kStateCount; ++lane) {
    const double* state = positions.data() + std::min(first + lane, last) * variables;
    for (std::size_t i = 0; i < variables; ++i) {
      work.variables[i].of[lane] = state[i];
    }
  }
}

void readLinkPoses(const StatesWork& work, std::size_t lane, std::vector<Pose>& world_from_link) {
  world_from_link.resize(work.plan.links.size());
  for (std::size_t i = 0; i < work.plan.links.size(); ++i) {
    const LinkPlace& place = work.plan.links[i];
    world_from_link[i] = place.frame == MovingFrame::kWorld
                             ? place.frame_from_link
                             : poseOf(work.frames[place.frame], lane) * place.frame_from_link;
  }
}

double plainStateDistance(const CycleSetup& setup, const StatesWork& work, const StatePair& pair,
                          std::size_t lane) noexcept {
  const Core& a = setup.cores[pair.a];
  const Core& b = setup.cores[pair.b];
  return plainDistance(a, bodyPose(a.kind, work.bodies[pair.a], lane), b,
                       bodyPose(b.kind, work.bodies[pair.b], lane))
      .distance;
}

void checkStates(const CycleSetup& setup, const JointPositions& positions, StateQuestion question,
                 StatesWork& work, std::vector<StateCheck>& checks) {
  judgeStates(setup, positions, question, false, work, checks);
}

void checkStatesExactly(const CycleSetup& setup, const JointPositions& positions,
                        StateQuestion question, StatesWork& work, std::vector<StateCheck>& checks) {
  judgeStates(setup, positions, question, true, work, checks);
}

}  // namespace collision_monitor
