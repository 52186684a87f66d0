// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "digests/robot_digests.h"

#include <random>

#include "collision_monitor/pipeline/search_pairs.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/run_cycle.h"
#include "pipeline/states/check_states.h"
#include "pipeline/trajectory/check_trajectory.h"
#include "support/robots/robot_moves.h"

namespace collision_monitor::test {
namespace {

void add(const std::optional<PosedShape>& inner, Digest& digest) {
  digest.add(inner.has_value());
  if (inner) {
    digest.add(inner->shape);
    digest.add(inner->geometry_from_body);
  }
}

void add(const PairDistance& distance, Digest& digest) {
  digest.add(distance.pair);
  digest.add(distance.quality);
  digest.add(distance.is_refined);
  digest.add(distance.is_raised);
  digest.add(distance.measured.distance);
  digest.add(distance.measured.point_on_a);
  digest.add(distance.measured.point_on_b);
  digest.add(distance.measured.normal_a_to_b);
  digest.add(distance.closing_speed);
  digest.add(distance.time_to_contact);
}

void add(const PairDistances& distances, Digest& digest) {
  digest.add(distances.pairs.size());
  for (const PairDistance& distance : distances.pairs) {
    add(distance, digest);
  }
  digest.add(distances.passed.size());
  for (const PassedContact& passed : distances.passed) {
    digest.add(passed.time);
    add(passed.distance, digest);
    digest.add(passed.world_from_link_a);
    digest.add(passed.world_from_link_b);
  }
}

void add(const PairEvents& events, Digest& digest) {
  digest.add(events.verdicts);
  digest.add(events.closest);
  digest.add(events.passed);
  digest.add(events.estimated);
  digest.add(events.soonest);
  digest.add(events.changes.size());
  for (const VerdictChange& change : events.changes) {
    digest.add(change.link_pair);
    digest.add(change.before);
    digest.add(change.after);
  }
  digest.add(events.island_of_link);
  digest.add(events.closest_of_all);
  digest.add(events.time_to_contact);
  digest.add(events.overall);
}

void addCycles(const CycleSetup& setup, double rate, Digest& digest) {
  constexpr std::size_t kCycles = 1000;
  Mover mover(setup.model, rate, 1.0);
  CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::automatic);
  for (std::size_t cycles = 0; cycles < kCycles;) {
    for (const LinkPoses& poses : mover.next()) {
      runCycle(setup, poses, buffers);
      add(buffers.distances, digest);
      add(buffers.events, digest);
      digest.add(buffers.memory.speed.scale);
      ++cycles;
    }
  }
}

void add(const std::vector<StateCheck>& checks, Digest& digest) {
  for (const StateCheck& check : checks) {
    digest.add(check.verdict);
    digest.add(check.quality);
    digest.add(check.has_pair);
    digest.add(check.pair);
    digest.add(check.distance);
  }
}

}  // namespace

Digest digestOfFits(const CycleSetup& setup) {
  Digest digest;
  for (std::size_t i = 0; i < setup.bodies.size(); ++i) {
    const Body& body = setup.bodies[i];
    digest.add(body.link);
    digest.add(body.element);
    digest.add(body.link_from_body);
    digest.add(body.shape);
    digest.add(body.is_exact);
    digest.add(setup.labels[i].overshoot.max);
    digest.add(setup.labels[i].widening);
  }
  for (const Element& element : setup.elements) {
    digest.add(element.link);
    digest.add(element.link_from_element);
    digest.add(element.mesh_excess);
    digest.add(element.padding);
    add(element.inner.sphere, digest);
    add(element.inner.capsule, digest);
  }
  return digest;
}

Digest digestOfPairs(const CycleSetup& setup) {
  Digest digest;
  for (const LinkPair& pair : setup.link_pairs) {
    digest.add(pair.a);
    digest.add(pair.b);
    digest.add(pair.reason);
  }
  for (const BodyPair& pair : setup.table.pairs()) {
    digest.add(pair.a);
    digest.add(pair.b);
  }
  return digest;
}

Digest digestOfCycles(const CycleSetup& setup) {
  Digest digest;
  addCycles(setup, 1000.0, digest);
  addCycles(setup, 50.0, digest);
  return digest;
}

Digest digestOfStates(const CycleSetup& setup) {
  constexpr int kStates = 64;
  std::mt19937_64 random(20260101);
  JointPositions states;
  for (int i = 0; i < (setup.model.variable_count == 0 ? 1 : kStates); ++i) {
    const JointPositions state = drawPositions(setup.model, random);
    states.insert(states.end(), state.begin(), state.end());
  }
  StatesWork work =
      makeStatesWork(setup, standingAt(setup.model, std::vector<Pose>(setup.model.robots.size())));
  Digest digest;
  for (const StateQuestion question : {StateQuestion::contact, StateQuestion::nearest}) {
    std::vector<StateCheck> checks;
    checkStates(setup, states, question, work, checks);
    add(checks, digest);
    checkStatesExactly(setup, states, question, work, checks);
    add(checks, digest);
  }
  return digest;
}

Digest digestOfTrajectory(const CycleSetup& setup) {
  TrajectoryOptions options;
  options.budget = 1'000'000;
  const LinkPoses start = posesAt(setup.model, defaultPositions(setup.model));
  const TrajectoryReport report = checkTrajectory(setup, randomPath(setup.model), start, options);
  Digest digest;
  for (const PairApproach& pair : report.pairs) {
    digest.add(pair.state);
    digest.add(pair.time);
    digest.add(pair.at_least);
    add(pair.nearest, digest);
  }
  digest.add(report.first_contact);
  digest.add(report.world_from_link);
  return digest;
}

Digest digestOfPairSearch(const CycleSetup& setup) {
  PairSearchOptions options;
  options.states = 500;
  options.most_cells = 200;
  Digest digest;
  for (const PairFound& found : searchPairs(setup, options)) {
    digest.add(found.a);
    digest.add(found.b);
    digest.add(found.finding);
    digest.add(found.is_proven);
    digest.add(found.joints);
    digest.add(found.touching);
    digest.add(found.nearest);
  }
  return digest;
}

}  // namespace collision_monitor::test
