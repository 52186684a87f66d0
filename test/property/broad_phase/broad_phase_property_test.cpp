// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "collision_monitor/broad_phase/broad_phase.h"
#include "support/random_poses.h"

namespace collision_monitor {
namespace {

using test::Random;

PairTable randomTable(Random& random, std::uint32_t bodies) {
  std::vector<BodyPair> pairs;
  for (std::uint32_t a = 0; a < bodies; ++a) {
    for (std::uint32_t b = a + 1; b < bodies; ++b) {
      if (random() % 4 != 0) {
        pairs.push_back({BodyId{a}, BodyId{b}});
      }
    }
  }
  return PairTable(pairs, bodies);
}

/// Positions on a coarse lattice, so that boxes often touch or share end points.
BodyBounds randomBounds(Random& random, std::size_t bodies) {
  BodyBounds bounds;
  for (std::size_t i = 0; i < bodies; ++i) {
    const Eigen::Vector3d min = (8.0 * test::randomPoint(random, 1.0)).array().round();
    const Eigen::Vector3d size = (2.0 + 2.0 * test::randomPoint(random, 1.0).array()).round();
    bounds.boxes.push_back({min, min + size});
    bounds.known.push_back(random() % 10 != 0 ? 1 : 0);
  }
  return bounds;
}

TEST(BroadPhaseProperty, sweepAndPruneFindsWhatBruteForceFinds) {
  constexpr unsigned kSeed = 1;
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  Random random(kSeed);
  std::size_t found = 0;
  for (int round = 0; round < 500; ++round) {
    const auto bodies = static_cast<std::uint32_t>(random() % 40);
    const PairTable table = randomTable(random, bodies);
    BroadPhase brute_force = BruteForce{};
    BroadPhase sweep_and_prune = SweepAndPrune(bodies);
    std::vector<PairId> expected;
    std::vector<PairId> actual;
    for (int frame = 0; frame < 10; ++frame) {  // the sorted axes are carried on
      const BodyBounds bounds = randomBounds(random, bodies);
      findCandidates(brute_force, bounds, table, expected);
      findCandidates(sweep_and_prune, bounds, table, actual);
      ASSERT_EQ(actual, expected) << "round " << round << ", frame " << frame;
      found += expected.size();
    }
  }
  EXPECT_GT(found, 10000U) << "the scenes are too sparse to prove anything";
}

}  // namespace
}  // namespace collision_monitor
