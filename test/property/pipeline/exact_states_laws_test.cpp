// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "collision_monitor/geometry/ids.h"
#include "collision_monitor/model/kinematics.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/run_cycle.h"
#include "pipeline/states/check_states.h"
#include "support/allocation_guard.h"
#include "support/fixed_seed.h"
#include "support/query_meshes.h"
#include "support/reference/convex_measure.h"
#include "support/robots/geometry_setup.h"
#include "support/robots/hand_made_setup.h"
#include "support/robots/random_model.h"
#include "support/robots/ruled_setup.h"
#include "support/sample_meshes.h"
#include "support/sanitizer.h"

// States of robots of meshes, held to cycles without a budget.
namespace collision_monitor::test::exact_states {
namespace {

Geometry anyGeometry(Random& random) {
  switch (random() % 6) {
    case 0:
      return scaled(angleMesh(), 0.5);
    case 1:
      return bumpyMesh(0.08, 8);
    case 2: {
      TriangleMesh open = sphereMesh(0.1, 12);
      open.triangles.pop_back();
      return open;
    }
    case 3:
      return Cylinder{0.05, 0.1};
    case 4:
      return boxMesh({0.05, 0.08, 0.03});
    default:
      return Capsule{0.08, 0.03};
  }
}

/// A random tree of links near each other, one geometry a link.
CycleSetup anyRobot(double contact_distance, Random& random) {
  const std::size_t links = 3 + random() % 4;
  std::vector<Geometry> geometries;
  for (std::size_t i = 0; i < links; ++i) {
    geometries.push_back(anyGeometry(random));
  }
  SetupOptions options;
  options.limits.contact_distance = contact_distance;
  CycleSetup setup = geometrySetup(geometries, options);
  setup.is_continuous = false;
  do {
    setup.model = randomModel(links, random);
  } while (setup.model.variable_count == 0);
  for (Joint& joint : setup.model.joints) {
    joint.parent_from_joint.translation *= 0.25;
  }
  return setup;
}

/// Gives some pairs limits of their own.
CycleSetup ruled(CycleSetup setup, Random& random) {
  giveRules({ruleForSome(randomLimits(random), setup, random),
             ruleForSome(randomLimits(random), setup, random)},
            setup);
  return setup;
}

struct Scene {
  Scene(double contact_distance, Random& random, bool has_rules = false)
      : setup(has_rules ? ruled(anyRobot(contact_distance, random), random)
                        : anyRobot(contact_distance, random)),
        work(makeStatesWork(setup, standingAt(setup.model, {Pose()}))),
        buffers(makeBuffers(setup, BroadPhaseKind::brute_force)) {
    buffers.refine.limits.budget = std::numeric_limits<std::uint32_t>::max();
    for (std::size_t i = 0; i < kCount * setup.model.variable_count; ++i) {
      positions.push_back(uniform(random, -1.5, 1.5));
    }
  }

  std::vector<StateCheck> check(StateQuestion question) {
    std::vector<StateCheck> checks;
    checkStatesExactly(setup, positions, question, work, checks);
    return checks;
  }

  const PairDistance* runCycleAt(std::size_t state) {
    const auto first =
        positions.begin() + static_cast<std::ptrdiff_t>(state * setup.model.variable_count);
    const JointPositions of_state(first,
                                  first + static_cast<std::ptrdiff_t>(setup.model.variable_count));
    LinkPoses poses = knownPoses(setup);
    placeLinks(setup.model, of_state, {Pose()}, poses.world_from_link);
    resetMemory(buffers);
    runCycle(setup, poses, buffers);
    const std::uint32_t closest = buffers.events.closest_of_all;
    return closest == kNone ? nullptr : &buffers.distances.pairs[closest];
  }

  /// [m] Of the pairs of convex elements where the last cycle was.
  double leastOfConvex() const {
    double least = std::numeric_limits<double>::infinity();
    for (const ElementPair& pair : setup.element_pairs) {
      const auto& a = setup.elements[index(pair.a)].convex;
      const auto& b = setup.elements[index(pair.b)].convex;
      if (a && b) {
        const auto& poses = buffers.body_poses.world_from_element;
        const ConvexDistance found =
            measureCold(*a, poses[index(pair.a)], *b, poses[index(pair.b)]);
        least = std::min(least, found.measured.distance);
      }
    }
    return least;
  }

  static constexpr std::size_t kCount = 19;
  CycleSetup setup;
  StatesWork work;
  CycleBuffers buffers;
  JointPositions positions;
};

TEST(ExactStatesLaws, verdictsAreThoseOfCyclesWithoutABudget) {
  Random random(kSeed);
  std::size_t contacts = 0;
  std::size_t clear = 0;
  const int kRounds = test::caseCount(60);
  for (int round = 0; round < kRounds; ++round) {
    Scene scene(round % 3 == 0 ? 0.004 : 0.0, random, 3 * round >= 2 * kRounds);
    const std::vector<StateCheck> contact = scene.check(StateQuestion::contact);
    const std::vector<StateCheck> nearest = scene.check(StateQuestion::nearest);
    for (std::size_t i = 0; i < Scene::kCount; ++i) {
      SCOPED_TRACE(testing::Message() << "round " << round << ", state " << i);
      const PairDistance* closest = scene.runCycleAt(i);
      const Verdict verdict = scene.buffers.events.overall;
      ASSERT_EQ(nearest[i].verdict, verdict);
      ASSERT_EQ(contact[i].verdict == Verdict::contact, verdict == Verdict::contact);
      ASSERT_EQ(contact[i].has_pair, verdict == Verdict::contact);
      ASSERT_TRUE(nearest[i].has_pair) << "also if nothing is within the warning distance";
      ++(verdict == Verdict::contact ? contacts : clear);
      if (verdict == Verdict::warning && closest != nullptr && closest->quality == Quality::exact) {
        ASSERT_NEAR(nearest[i].distance, closest->measured.distance, 1e-9);
        ASSERT_EQ(nearest[i].quality, Quality::exact);
      } else if (verdict == Verdict::contact) {
        ASSERT_LE(nearest[i].distance, scene.leastOfConvex() + 1e-9);
      }
    }
  }
  EXPECT_GT(contacts, test::caseCount(std::size_t{100}));
  EXPECT_GT(clear, test::caseCount(std::size_t{100}));
}

TEST(ExactStatesLaws, aStateIsJudgedAlikeWhateverCameBefore) {
  Random random(kSeed);
  for (int round = 0; round < 10; ++round) {
    Scene scene(0.0, random);
    const std::vector<StateCheck> once = scene.check(StateQuestion::nearest);
    scene.check(StateQuestion::contact);
    const std::vector<StateCheck> again = scene.check(StateQuestion::nearest);
    for (std::size_t i = 0; i < Scene::kCount; ++i) {
      ASSERT_EQ(again[i].verdict, once[i].verdict);
      if (once[i].verdict != Verdict::contact) {
        ASSERT_NEAR(again[i].distance, once[i].distance, 1e-9);
      }
    }
  }
}

/// Blocks are filled anew after each search: no answer may go to another state.
TEST(ExactStatesLaws, manyStatesAreJudgedAsEachAlone) {
  Random random(kSeed);
  Scene scene(0.0, random);
  const std::size_t n = scene.setup.model.variable_count;
  JointPositions many;
  for (std::size_t i = 0; i < (kOpenStates + 21) * n; ++i) {
    many.push_back(uniform(random, -1.5, 1.5));
  }
  many[5 * n] = std::numeric_limits<double>::quiet_NaN();
  for (const StateQuestion question : {StateQuestion::nearest, StateQuestion::contact}) {
    std::vector<StateCheck> together;
    checkStatesExactly(scene.setup, many, question, scene.work, together);
    ASSERT_EQ(together.size(), kOpenStates + 21);
    EXPECT_EQ(together[5].verdict, Verdict::unknown);
    for (std::size_t i = 0; i < together.size(); ++i) {
      const auto first = many.begin() + static_cast<std::ptrdiff_t>(i * n);
      const JointPositions one(first, first + static_cast<std::ptrdiff_t>(n));
      std::vector<StateCheck> alone;
      checkStatesExactly(scene.setup, one, question, scene.work, alone);
      ASSERT_EQ(alone[0].verdict, together[i].verdict) << "state " << i;
      if (together[i].verdict == Verdict::clear || together[i].verdict == Verdict::warning) {
        ASSERT_NEAR(alone[0].distance, together[i].distance, 1e-9);
      }
    }
  }
}

TEST(ExactStatesLaws, checkingAllocatesNothing) {
  Random random(kSeed);
  Scene scene(0.0, random);
  std::vector<StateCheck> checks(Scene::kCount);
  const AllocationGuard guard;
  checkStatesExactly(scene.setup, scene.positions, StateQuestion::nearest, scene.work, checks);
  checkStatesExactly(scene.setup, scene.positions, StateQuestion::contact, scene.work, checks);
  EXPECT_EQ(guard.count(), 0U);
}

}  // namespace
}  // namespace collision_monitor::test::exact_states
