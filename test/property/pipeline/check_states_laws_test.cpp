// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <limits>
#include <utility>

#include "collision_monitor/model/kinematics.h"
#include "narrow_phase/distance.h"
#include "pipeline/states/check_states.h"
#include "pipeline/states/states_block.h"
#include "pipeline/trajectory/link_pair_distance.h"
#include "support/allocation_guard.h"
#include "support/fixed_seed.h"
#include "support/instruction_sets.h"
#include "support/robots/hand_made_setup.h"
#include "support/robots/random_model.h"

// Many states against each state alone, measured pair by pair with the plain routines.
namespace collision_monitor::test {
namespace {

constexpr std::size_t kStates = 3 * kStateCount + 5;

/// A random tree of any joints, with the shapes of randomSetup on its links.
CycleSetup randomRobot(unsigned seed) {
  Random random(seed);
  CycleSetup setup = randomSetup(3 + random() % 8, seed);
  const std::size_t links = setup.model.links.size();
  do {
    setup.model = randomModel(links, random);
  } while (setup.model.variable_count == 0);
  for (Link& link : setup.model.links) {
    link.has_given_shapes = true;
  }
  for (Joint& joint : setup.model.joints) {
    joint.parent_from_joint.translation *= 0.4;  // crowded
  }
  return setup;
}

JointPositions randomPositions(const CycleSetup& setup, Random& random) {
  JointPositions positions;
  for (std::size_t i = 0; i < kStates * setup.model.variable_count; ++i) {
    positions.push_back(uniform(random, -0.5, 0.5));
  }
  return positions;
}

/// The same with all bodies level: their faces and edges stay parallel, but for rounding and joints
/// that turn.
CycleSetup levelRobot(unsigned seed) {
  CycleSetup setup = randomRobot(seed);
  for (Joint& joint : setup.model.joints) {
    joint.parent_from_joint.rotation.setIdentity();
    joint.axis = Eigen::Vector3d::Unit(static_cast<Eigen::Index>(seed % 3));
  }
  for (Body& body : setup.bodies) {
    body.link_from_body.rotation.setIdentity();
  }
  return setup;
}

/// A robot somewhere, and positions of its joints.
struct Scene {
  explicit Scene(unsigned seed) : Scene(randomRobot(seed), seed) {}

  Scene(CycleSetup its_setup, unsigned seed) : setup(std::move(its_setup)) {
    Random random(seed);
    roots = {randomPose(random, 1.0)};
    positions = randomPositions(setup, random);
    work = makeStatesWork(setup, standingAt(setup.model, roots));
  }

  CycleSetup setup;
  std::vector<Pose> roots;
  JointPositions positions;
  StatesWork work;
};

double leastByPlainTwins(const CycleSetup& setup, const JointPositions& state,
                         const std::vector<Pose>& roots) {
  std::vector<Pose> links;
  placeLinks(setup.model, state, roots, links);
  double least = std::numeric_limits<double>::infinity();
  for (const BodyPair& pair : setup.table.pairs()) {
    const Body& a = setup.bodies[index(pair.a)];
    const Body& b = setup.bodies[index(pair.b)];
    least = std::min(least, distanceBetween(a.shape, links[index(a.link)] * a.link_from_body,
                                            b.shape, links[index(b.link)] * b.link_from_body)
                                .distance);
  }
  return least;
}

Verdict verdictOf(double distance, const Limits& limits) {
  return distance <= limits.contact_distance   ? Verdict::contact
         : distance <= limits.warning_distance ? Verdict::warning
                                               : Verdict::clear;
}

JointPositions stateOf(const CycleSetup& setup, const JointPositions& positions, std::size_t i) {
  const auto begin = positions.begin() + static_cast<long>(i * setup.model.variable_count);
  return {begin, begin + static_cast<long>(setup.model.variable_count)};
}

bool isSame(const StateCheck& one, const StateCheck& other) {
  return one.verdict == other.verdict && one.has_pair == other.has_pair && one.pair == other.pair &&
         std::memcmp(&one.distance, &other.distance, sizeof one.distance) == 0;
}

TEST(CheckStatesLaws, verdictsAndDistancesAreThoseOfEveryStateAlone_onEveryInstructionSet) {
  std::size_t contacts = 0;
  std::size_t clear = 0;
  for (unsigned round = 0; round < 60; ++round) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed + round);
    Scene scene(kSeed + round);
    auto& [setup, roots, positions, work] = scene;
    std::vector<StateCheck> first;
    for (const std::int64_t target : instructionSets()) {
      const OnlyInstructionSet only(target);
      std::vector<StateCheck> nearest;
      std::vector<StateCheck> contact;
      checkStates(setup, positions, StateQuestion::nearest, work, nearest);
      checkStates(setup, positions, StateQuestion::contact, work, contact);
      std::vector<StateCheck> alone;
      for (std::size_t i = 0; i < kStates; ++i) {
        checkStates(setup, stateOf(setup, positions, i), StateQuestion::contact, work, alone);
        ASSERT_TRUE(isSame(alone[0], contact[i])) << hwy::TargetName(target);
        ASSERT_EQ(contact[i].verdict == Verdict::contact, nearest[i].verdict == Verdict::contact);
        ASSERT_TRUE(first.empty() || isSame(first[i], nearest[i])) << hwy::TargetName(target);
      }
      first = nearest;
    }
    for (std::size_t i = 0; i < kStates; ++i) {
      const double least = leastByPlainTwins(setup, stateOf(setup, positions, i), roots);
      ASSERT_NEAR(first[i].distance, least, 1e-12);
      ASSERT_EQ(first[i].verdict, verdictOf(least, setup.limits));
      contacts += first[i].verdict == Verdict::contact ? 1 : 0;
      clear += first[i].verdict == Verdict::clear ? 1 : 0;
    }
  }
  EXPECT_GT(contacts, 100U);
  EXPECT_GT(clear, 100U);
}

/// No points are told, so none need be unique.
TEST(CheckStatesLaws, distancesOfLevelBodiesAreThoseOfPlainTwins) {
  std::size_t deep = 0;
  std::size_t apart = 0;
  for (unsigned round = 0; round < 60; ++round) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed + round);
    Scene scene(levelRobot(kSeed + round), kSeed + round);
    auto& [setup, roots, positions, work] = scene;
    std::vector<StateCheck> nearest;
    checkStates(setup, positions, StateQuestion::nearest, work, nearest);
    for (std::size_t i = 0; i < kStates; ++i) {
      const double least = leastByPlainTwins(setup, stateOf(setup, positions, i), roots);
      ASSERT_NEAR(nearest[i].distance, least, 1e-12);
      deep += least < 0.0 ? 1 : 0;
      apart += least > 0.0 ? 1 : 0;
    }
  }
  EXPECT_GT(deep, 100U);
  EXPECT_GT(apart, 100U);
}

TEST(CheckStatesLaws, linkPairsAreAsFarApartAsTheirNearestBodies) {
  constexpr double kReach = 0.3;
  std::size_t within = 0;
  for (unsigned round = 0; round < 20; ++round) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed + round);
    Scene scene(kSeed + round);
    auto& [setup, roots, positions, work] = scene;
    fillVariables(positions, kStateCount, work);
    placeStates(setup, work);
    std::vector<StateNumber> nearest(setup.checked.size());
    for (StateNumber& distances : nearest) {
      std::fill(std::begin(distances.of), std::end(distances.of), kReach);
    }
    measureLinkPairs(setup, work, nearest);
    LinkPairMeasures measures(setup);
    for (std::size_t i = 0; i < kStateCount; ++i) {
      std::vector<Pose> links;
      placeLinks(setup.model, stateOf(setup, positions, kStateCount + i), roots, links);
      for (LinkPairIndex pair = 0; pair < setup.checked.size(); ++pair) {
        const double distance = bodyDistance(measures, pair, links).measured.distance;
        ASSERT_NEAR(nearest[pair].of[i], std::min(distance, kReach), 1e-12);
        within += distance < kReach ? 1 : 0;
      }
    }
  }
  EXPECT_GT(within, 100U);
}

/// Balls around elements spare most pairs, and change no answer.
TEST(CheckStatesLaws, nearestBodiesAreThoseOfAllPairs) {
  constexpr std::size_t kLeftOut = 3;
  for (unsigned round = 0; round < 40; ++round) {
    Scene scene(kSeed + round);
    auto& [setup, roots, positions, work] = scene;
    fillVariables(positions, 0, work);
    placeStates(setup, work);
    StatesBlock all;
    judgeBlock(setup, StateQuestion::nearest, work, all);
    placeCenters(work);
    StateNumber asked;
    std::fill(std::begin(asked.of), std::end(asked.of), kContactsAsked);
    asked.of[kLeftOut] = kNotAsked;
    StatesBlock found;
    judgeNearest(setup, asked, work, found);
    EXPECT_EQ(found.distance.of[kLeftOut], std::numeric_limits<double>::infinity());
    for (std::size_t lane = 0; lane < kStateCount; ++lane) {
      if (lane != kLeftOut) {
        ASSERT_EQ(found.distance.of[lane], all.distance.of[lane]);
        ASSERT_EQ(found.pair.of[lane], all.pair.of[lane]);
        ASSERT_EQ(found.is_contact.of[lane], all.is_contact.of[lane]);
        ASSERT_EQ(found.is_warning.of[lane], all.is_warning.of[lane]);
      }
    }
  }
}

TEST(CheckStatesLaws, checkingAllocatesNothing) {
  Scene scene(kSeed);
  auto& [setup, roots, positions, work] = scene;
  std::vector<StateCheck> checks(kStates);
  const AllocationGuard guard;
  checkStates(setup, positions, StateQuestion::nearest, work, checks);
  checkStatesExactly(setup, positions, StateQuestion::contact, work, checks);
  EXPECT_EQ(guard.count(), 0U);
}

}  // namespace
}  // namespace collision_monitor::test
