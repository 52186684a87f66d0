// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "pipeline/cycle/run_cycle.h"
#include "pipeline/states/check_states.h"
#include "pipeline/trajectory/check_trajectory.h"
#include "support/query_meshes.h"
#include "support/robots/geometry_setup.h"
#include "support/robots/hand_made_setup.h"

// A concave mesh and a ball were 1 cm apart, each with a padding of 1 cm. With a contact_distance
// of -2 cm the cycle rightly warned, while check_states and check_trajectory said contact.
namespace collision_monitor::test {
namespace {

class PaddingOfConcaveMeshes : public testing::Test {
 protected:
  /// A ball beside an angle. @param gap [m] between their geometries
  static CycleSetup besideAngle(double gap) {
    SetupOptions options;
    options.limits.contact_distance = -0.02;
    options.limits.warning_distance = 0.05;
    options.padding = 0.01;
    CollisionElement angle;
    angle.geometry = angleMesh();
    CollisionElement ball;
    ball.geometry = Sphere{0.05};
    ball.link_from_geometry.translation = {-0.05 - gap, 0.15, 0.0};
    return linkSetup({{angle}, {ball}}, options);
  }
  static Verdict ofCycle(const CycleSetup& setup) {
    CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::brute_force);
    runCycle(setup, knownPoses(setup), buffers);
    return buffers.events.overall;
  }
  static Verdict ofState(const CycleSetup& setup, StateQuestion question) {
    StatesWork work = makeStatesWork(setup, standingAt(setup.model, {Pose()}));
    std::vector<StateCheck> checks;
    checkStatesExactly(setup, {}, question, work, checks);
    return checks.at(0).verdict;
  }
  static Verdict ofTrajectory(const CycleSetup& setup) {
    JointPath path;
    path.times = {0.0};
    return verdictOf(checkTrajectory(setup, path, knownPoses(setup), {}), {});
  }
};

TEST_F(PaddingOfConcaveMeshes, overlapsByLessThanIsAllowed_isNoContact) {
  const CycleSetup setup = besideAngle(0.01);
  EXPECT_EQ(ofCycle(setup), Verdict::warning);
  EXPECT_EQ(ofState(setup, StateQuestion::contact), Verdict::clear);
  EXPECT_EQ(ofState(setup, StateQuestion::nearest), Verdict::warning);
  EXPECT_EQ(ofTrajectory(setup), Verdict::warning);
}

TEST_F(PaddingOfConcaveMeshes, geometriesOverlap_isAContact) {
  const CycleSetup setup = besideAngle(-0.001);
  EXPECT_EQ(ofCycle(setup), Verdict::contact);
  EXPECT_EQ(ofState(setup, StateQuestion::contact), Verdict::contact);
  EXPECT_EQ(ofState(setup, StateQuestion::nearest), Verdict::contact);
  EXPECT_EQ(ofTrajectory(setup), Verdict::contact);
}

}  // namespace
}  // namespace collision_monitor::test
