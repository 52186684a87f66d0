// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstring>

#include "collision_monitor/geometry/ids.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/distance_cache.h"
#include "pipeline/cycle/run_cycle.h"
#include "support/allocation_guard.h"
#include "support/query_meshes.h"
#include "support/random_poses.h"
#include "support/robots/geometry_setup.h"
#include "support/robots/hand_made_setup.h"
#include "support/sample_meshes.h"

namespace collision_monitor {
namespace {

using test::Random;

constexpr unsigned kSeed = 11;

std::vector<Geometry> mixedGeometries() {
  return {test::bumpyMesh(0.2, 16), test::angleMesh(),        Cylinder{0.1, 0.05},
          Box{{0.1, 0.04, 0.03}},   test::bumpyMesh(0.1, 12), test::prismMesh(0.06, 0.1, 9),
          Capsule{0.08, 0.03}};
}

CycleSetup mixedSetup(const std::vector<Geometry>& geometries, std::uint32_t max_shapes = 2) {
  SetupOptions options;
  options.default_limits.max_shapes = max_shapes;
  return test::geometrySetup(geometries, options);
}

void drift(Random& random, LinkPoses& poses) {
  for (Pose& pose : poses.world_from_link) {
    pose = random() % 100 == 0 ? test::randomPose(random, 0.25) : pose;
    pose.translation += test::randomPoint(random, 0.005);
  }
  for (LinkStatus& status : poses.status) {
    status = random() % 50 == 0 ? LinkStatus::stale : LinkStatus::known;
  }
}

bool sameBytes(const PairDistance& one, const PairDistance& other) {
  return one.pair == other.pair && one.quality == other.quality &&
         one.is_refined == other.is_refined &&
         std::memcmp(&one.measured, &other.measured, sizeof one.measured) == 0;
}

/// Whatever the budget, so that much of it is spent in the middle of searches.
class RefineCycles : public testing::TestWithParam<std::uint32_t> {};

TEST_P(RefineCycles, allocateNothingAndEveryBroadPhaseGivesTheSameBytes) {
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  CycleSetup setup = mixedSetup(mixedGeometries());
  setup.is_continuous = true;
  setup.refine.budget = GetParam();
  CycleBuffers brute_force = makeBuffers(setup, BroadPhaseKind::brute_force);
  CycleBuffers sweep_and_prune = makeBuffers(setup, BroadPhaseKind::sweep_and_prune);
  LinkPoses poses = test::randomLinkPoses(setup, 0.25, kSeed);
  Random random(kSeed);
  std::size_t allocations = 0;
  std::size_t refined = 0;
  std::size_t left = 0;
  std::size_t passed = 0;
  for (int cycle = 0; cycle < 2000; ++cycle) {
    drift(random, poses);
    {
      const test::AllocationGuard guard;
      runCycle(setup, poses, brute_force);
      runCycle(setup, poses, sweep_and_prune);
      allocations += guard.count();
    }
    const auto& one = brute_force.distances.pairs;
    const auto& other = sweep_and_prune.distances.pairs;
    ASSERT_TRUE(std::equal(one.begin(), one.end(), other.begin(), other.end(), sameBytes));
    const auto& passed_one = brute_force.distances.passed;
    const auto& passed_other = sweep_and_prune.distances.passed;
    ASSERT_TRUE(std::equal(passed_one.begin(), passed_one.end(), passed_other.begin(),
                           passed_other.end(), [](const auto& x, const auto& y) {
                             return x.time == y.time && sameBytes(x.distance, y.distance);
                           }));
    passed += passed_one.size();
    ASSERT_EQ(brute_force.events.verdicts, sweep_and_prune.events.verdicts);
    refined += brute_force.counters.refined;
    left += brute_force.counters.left;
  }
  EXPECT_EQ(allocations, 0U);
  EXPECT_GT(refined, 1000U) << "the scenes are too sparse to prove anything";
  EXPECT_EQ(left > 100U, GetParam() < 10000U);
  EXPECT_GT(passed, 5U) << "links move too little to pass each other";
}

/// Small steps, so that bodies that are not the nearest can wait; sometimes a jump.
void creep(Random& random, LinkPoses& poses) {
  for (Pose& pose : poses.world_from_link) {
    pose = random() % 1000 == 0 ? test::randomPose(random, 0.25) : pose;
    pose.translation += test::randomPoint(random, 2e-4);
  }
}

TriangleMesh combMesh() {
  TriangleMesh comb = test::boxMesh({0.2, 0.02, 0.02});
  for (const double x : {-0.18, -0.06, 0.06, 0.18}) {
    comb = test::joined(comb, test::boxMeshAt({0.02, 0.02, 0.08}, {x, 0.0, 0.1}));
  }
  return comb;
}

TEST(RefineProperty, bodiesThatWaitChangeNoByte) {
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  SetupOptions options;
  options.default_limits.max_shapes = 6;
  const std::vector<CollisionElement> comb_and_ball = {
      {"comb", Pose(), combMesh()},
      {"ball", {Eigen::Matrix3d::Identity(), {0.0, 0.15, 0.0}}, test::bumpyMesh(0.05, 12)}};
  CycleSetup setup = test::linkSetup({3, comb_and_ball}, options);
  setup.is_continuous = true;
  setup.refine.budget = 20;
  CycleBuffers forgetful = makeBuffers(setup, BroadPhaseKind::brute_force);
  CycleBuffers remembering = makeBuffers(setup, BroadPhaseKind::brute_force);
  LinkPoses poses = test::randomLinkPoses(setup, 0.2, kSeed);
  Random random(kSeed);
  std::size_t of_all = 0;
  std::size_t of_nearest = 0;
  std::size_t had_to = 0;
  for (int cycle = 0; cycle < 10000; ++cycle) {
    creep(random, poses);
    forgetful.memory.distance_cache = makeDistanceCache(setup);
    forgetful.memory.distance_cache.has_lone = remembering.memory.distance_cache.has_lone = false;
    runCycle(setup, poses, forgetful);
    runCycle(setup, poses, remembering);
    const auto& one = forgetful.distances.pairs;
    const auto& other = remembering.distances.pairs;
    ASSERT_TRUE(std::equal(one.begin(), one.end(), other.begin(), other.end(), sameBytes));
    ASSERT_EQ(forgetful.distances.passed.size(), remembering.distances.passed.size());
    ASSERT_EQ(forgetful.events.verdicts, remembering.events.verdicts);
    of_all += forgetful.counters.measured;
    of_nearest += remembering.counters.measured;
    had_to += remembering.deferred.size();
  }
  EXPECT_LT(5 * of_nearest, 4 * of_all);
  EXPECT_GT(had_to, 100U) << "too few waited in vain to prove anything";
}

INSTANTIATE_TEST_SUITE_P(Budgets, RefineCycles, testing::Values(50U, 200U, 1000000U));

/// The distance of each pair of links, by LinkPairIndex; infinity where nothing was near.
std::vector<PairDistance> nearestOf(const CycleBuffers& buffers) {
  std::vector<PairDistance> nearest;
  for (const std::uint32_t place : buffers.events.closest) {
    nearest.push_back(place == kNone ? PairDistance() : buffers.distances.pairs[place]);
  }
  return nearest;
}

/// Searches that are cut short, resumed and begun from old triangles, against complete ones.
class StarvedCycles : public testing::TestWithParam<std::uint32_t> {};

TEST_P(StarvedCycles, sayWhatCompleteOnesSay_orABoundOfIt) {
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  const CycleSetup setup = mixedSetup(mixedGeometries(), 1);
  CycleBuffers starved = makeBuffers(setup, BroadPhaseKind::brute_force);
  CycleBuffers complete = makeBuffers(setup, BroadPhaseKind::brute_force);
  starved.refine.limits.budget = GetParam();
  complete.refine.limits.budget = 1000000;
  LinkPoses poses = test::randomLinkPoses(setup, 0.25, kSeed);
  Random random(kSeed);
  std::size_t exact = 0;
  for (int cycle = 0; cycle < 2000; ++cycle) {
    drift(random, poses);
    runCycle(setup, poses, starved);
    resetMemory(complete);
    runCycle(setup, poses, complete);
    const std::vector<PairDistance> found = nearestOf(starved);
    const std::vector<PairDistance> truth = nearestOf(complete);
    for (std::size_t i = 0; i < found.size(); ++i) {
      const double distance = found[i].measured.distance;
      if (found[i].quality == Quality::exact && distance > 0.0) {
        ASSERT_NEAR(distance, truth[i].measured.distance, 1e-9) << "cycle " << cycle;
        ++exact;
      } else if (found[i].quality == Quality::lower_bound && truth[i].quality == Quality::exact) {
        ASSERT_LE(distance, truth[i].measured.distance + 1e-9) << "cycle " << cycle;
      }
    }
  }
  EXPECT_GT(exact, 1000U);
}

INSTANTIATE_TEST_SUITE_P(Budgets, StarvedCycles, testing::Values(50U, 200U, 500U, 2000U));

/// One shape a link: its depth bounds that of the geometry. Of several shapes it does not, for to
/// part two that overlap least may not part the others.
class RefinedAndEnclosing : public testing::TestWithParam<std::uint32_t> {};

TEST_P(RefinedAndEnclosing, refinedDistancesAreNeverBelowThoseOfEnclosingShapes) {
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  const CycleSetup setup = mixedSetup(mixedGeometries(), GetParam());
  for (const std::uint32_t budget : {30U, 300U, 1000000U}) {
    CycleBuffers enclosing = makeBuffers(setup, BroadPhaseKind::brute_force);
    CycleBuffers refined = makeBuffers(setup, BroadPhaseKind::brute_force);
    enclosing.refine.limits.budget = 0;
    refined.refine.limits.budget = budget;
    for (unsigned round = 0; round < 500; ++round) {
      const LinkPoses poses = test::randomLinkPoses(setup, 0.25, kSeed + round);
      runCycle(setup, poses, enclosing);
      runCycle(setup, poses, refined);
      const std::vector<PairDistance> bounds = nearestOf(enclosing);
      const std::vector<PairDistance> values = nearestOf(refined);
      for (std::size_t i = 0; i < bounds.size(); ++i) {
        if (bounds[i].quality == Quality::unknown || values[i].quality == Quality::unknown) {
          continue;
        }
        if (GetParam() == 1 || bounds[i].measured.distance > 0.0) {
          ASSERT_GE(values[i].measured.distance, bounds[i].measured.distance - 1e-7);
        }
        ASSERT_TRUE(values[i].quality != Quality::estimate || values[i].measured.distance <= 0.0);
        const SignedDistance& found = values[i].measured;
        const Eigen::Vector3d across = found.distance * found.normal_a_to_b;
        ASSERT_LE((found.point_on_b - found.point_on_a - across).norm(), 1e-7)
            << "quality " << static_cast<int>(values[i].quality) << ", distance " << found.distance
            << ", round " << round << ", budget " << budget << ", pair " << i << " "
            << found.point_on_a.transpose() << " / " << found.point_on_b.transpose();
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, RefinedAndEnclosing, testing::Values(1U, 2U));

TEST(RefineProperty, linksInOtherOrder_sameDistancesAndOppositeNormals) {
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  std::vector<Geometry> geometries = mixedGeometries();
  const CycleSetup setup = mixedSetup(geometries);
  std::reverse(geometries.begin(), geometries.end());
  const CycleSetup reversed = mixedSetup(geometries);
  CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::brute_force);
  CycleBuffers of_reversed = makeBuffers(reversed, BroadPhaseKind::brute_force);
  buffers.refine.limits.budget = of_reversed.refine.limits.budget = 1000000;
  const std::size_t last = geometries.size() - 1;
  for (unsigned round = 0; round < 300; ++round) {
    LinkPoses poses = test::randomLinkPoses(setup, 0.25, kSeed + round);
    runCycle(setup, poses, buffers);
    std::reverse(poses.world_from_link.begin(), poses.world_from_link.end());
    runCycle(reversed, poses, of_reversed);
    for (std::size_t i = 0; i < setup.checked.size(); ++i) {
      const auto other = std::find_if(reversed.checked.begin(), reversed.checked.end(),
                                      [&](const CheckedLinkPair& pair) {
                                        return index(pair.a) == last - index(setup.checked[i].b) &&
                                               index(pair.b) == last - index(setup.checked[i].a);
                                      });
      const auto place = static_cast<std::size_t>(other - reversed.checked.begin());
      ASSERT_EQ(buffers.events.verdicts[i], of_reversed.events.verdicts[place]);
      const PairDistance one = nearestOf(buffers)[i];
      const PairDistance two = nearestOf(of_reversed)[place];
      ASSERT_EQ(one.quality, two.quality);
      if (one.quality == Quality::exact) {
        ASSERT_NEAR(one.measured.distance, two.measured.distance, 1e-9);
      }
    }
  }
}

}  // namespace
}  // namespace collision_monitor
