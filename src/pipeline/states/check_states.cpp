// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/states/check_states.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

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

/// A body's pose; of points and segments only what their kind needs is placed.
Pose bodyPose(CoreKind kind, const StatePose& pose, std::size_t lane) noexcept {
  const Pose one = poseOf(pose, lane);
  return kind == CoreKind::box       ? one
         : kind == CoreKind::segment ? poseAlong(one.rotation.col(2), one.translation)
                                     : Pose{Eigen::Matrix3d::Identity(), one.translation};
}

bool isFiniteState(const StatesWork& work, std::size_t lane) noexcept {
  return std::all_of(work.variables.begin(), work.variables.end(),
                     [&](const StateNumber& variable) { return std::isfinite(variable.of[lane]); });
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

/// Judges a block of states.
void judgeShapes(const CycleSetup& setup, StateQuestion question, std::size_t count,
                 StatesWork& work, StateCheck* checks) noexcept {
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

}  // namespace

StatesWork makeShapeStatesWork(const CycleSetup& setup, const StandingPoses& standing) {
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
  work.placed.reserve(kStateCount);
  work.frames.resize(work.plan.frames.size());
  partPairs(setup, work);
  return work;
}

StatesWork makeStatesWork(const CycleSetup& setup, const StandingPoses& standing) {
  StatesWork work = makeShapeStatesWork(setup, standing);
  work.open.reserve(kOpenStates);
  work.refinement = makeStatesRefinement(setup, work);
  return work;
}

void fillAll(const Eigen::Vector3d& v, StateNumber (&numbers)[3]) noexcept {
  for (std::size_t k = 0; k < 3; ++k) {
    std::fill(std::begin(numbers[k].of), std::end(numbers[k].of), v[static_cast<Eigen::Index>(k)]);
  }
}

StatePose everywhere(const Pose& pose) noexcept {
  StatePose state_pose;
  fillAll(pose.translation, state_pose.translation);
  fillAll(pose.rotation.col(0), state_pose.axis_x);
  fillAll(pose.rotation.col(1), state_pose.axis_y);
  fillAll(pose.rotation.col(2), state_pose.axis_z);
  return state_pose;
}

void fillVariables(const JointPositions& positions, std::size_t first, StatesWork& work) noexcept {
  const std::size_t count = std::min(kStateCount, countStates(positions, work) - first);
  work.placed.resize(count);
  std::iota(work.placed.begin(), work.placed.end(), static_cast<std::uint32_t>(first));
  fillPlaced(positions, work);
}

void fillPlaced(const JointPositions& positions, StatesWork& work) noexcept {
  const std::size_t variables = work.plan.variable_count;
  for (std::size_t lane = 0; lane < kStateCount; ++lane) {
    const std::size_t state = work.placed[std::min(lane, work.placed.size() - 1)];
    for (std::size_t i = 0; i < variables; ++i) {
      work.variables[i].of[lane] = positions[state * variables + i];
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

std::size_t countStates(const JointPositions& positions, const StatesWork& work) noexcept {
  const std::size_t variables = work.plan.variable_count;
  return variables == 0 ? 1 : positions.size() / variables;
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

void addUnknown(const StatesWork& work, std::vector<StateCheck>& checks) noexcept {
  for (StateCheck& check : checks) {
    check.verdict = work.is_split ? std::max(check.verdict, Verdict::unknown) : check.verdict;
  }
}

void checkStates(const CycleSetup& setup, const JointPositions& positions, StateQuestion question,
                 StatesWork& work, std::vector<StateCheck>& checks) {
  const std::size_t total = countStates(positions, work);
  checks.resize(total);
  for (std::size_t first = 0; first < total; first += kStateCount) {
    fillVariables(positions, first, work);
    placeStates(setup, work);
    judgeShapes(setup, question, std::min(kStateCount, total - first), work, &checks[first]);
  }
  addUnknown(work, checks);
}

}  // namespace collision_monitor
