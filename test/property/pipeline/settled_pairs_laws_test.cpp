// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "collision_monitor/motion/speed_scale.h"
#include "listening_scene.h"

// What is passed over while nobody listens says nothing new.
namespace collision_monitor::test::measure_told_laws {
namespace {

TEST(SettledPairsLaws, warningThatEnds_hasADistance) {
  const CycleSetup setup = crowdedSetup();
  Watches watches(setup);
  Drift drift(setup, 0.1);
  int ended = 0;
  for (int cycle = 0; cycle < 20000; ++cycle) {
    watches.run(setup, drift.next());
    for (const VerdictChange& change : watches.untold.events.changes) {
      const bool has_jumped = watches.told.events.closest[change.link_pair] == kNone;
      if (change.after == Verdict::clear && !has_jumped) {
        ASSERT_NE(watches.untold.events.closest[change.link_pair], kNone) << cycle;
        ++ended;
      }
    }
  }
  EXPECT_GT(ended, 20);
}

const PairDistance* nearestWarning(const PairEvents& events, const PairDistances& distances) {
  const PairDistance* nearest = nullptr;
  for (const LinkPairIndex pair : events.active) {
    if (events.verdicts[pair] == Verdict::warning && events.closest[pair] != kNone) {
      const PairDistance& closest = distances.pairs[events.closest[pair]];
      const bool is_nearer =
          nearest == nullptr || closest.measured.distance < nearest->measured.distance;
      nearest = is_nearer ? &closest : nearest;
    }
  }
  return nearest;
}

/// The sentence of a state names it, if there is no contact.
TEST(SettledPairsLaws, nearestWarning_isMeasured) {
  const CycleSetup setup = crowdedSetup();
  Watches watches(setup);
  Drift drift(setup, 0.1);
  int compared = 0;
  for (int cycle = 0; cycle < 20000; ++cycle) {
    watches.run(setup, drift.next());
    if (watches.told.events.overall == Verdict::contact || !watches.untold.events.changes.empty()) {
      continue;
    }
    const PairDistance* told = nearestWarning(watches.told.events, watches.told.distances);
    const PairDistance* untold = nearestWarning(watches.untold.events, watches.untold.distances);
    ASSERT_EQ(told == nullptr, untold == nullptr) << cycle;
    if (told != nullptr && told->quality == Quality::exact) {
      ASSERT_NEAR(told->measured.distance, untold->measured.distance, 1e-9) << cycle;
      ++compared;
    }
  }
  EXPECT_GT(compared, 5000);
}

/// Where nobody listens, a robot that was slowed down is set free at the same time or later.
TEST(SettledPairsLaws, scaleThatGrows_isNeverLarger) {
  CycleSetup setup = crowdedSetup();
  setup.ahead.stop.release_time = 0.1;
  Watches watches(setup);
  Drift drift(setup, 0.1);
  int growing = 0;
  int later = 0;
  for (int cycle = 0; cycle < 20000; ++cycle) {
    const double before = watches.told.memory.speed.scale;
    watches.run(setup, drift.next());
    if (isAnyEstimate(watches.told.distances)) {
      watches.untold.memory.speed = watches.told.memory.speed;
      continue;
    }
    const double told = watches.told.memory.speed.scale;
    const double untold = watches.untold.memory.speed.scale;
    ASSERT_LE(untold, told + 1e-5) << cycle;
    growing += told > before ? 1 : 0;
    later += untold < told - 1e-5 ? 1 : 0;
  }
  EXPECT_GT(growing, 100);
  EXPECT_LT(later, growing / 10);
}

/// Pairs that are passed over are warnings, and others are nearer, sooner and slower.
TEST(SettledPairsLaws, settledPairs_areWarnings_andOthersSayLess) {
  const CycleSetup setup = crowdedSetup();
  Watches watches(setup);
  Drift drift(setup, 0.1);
  int settled = 0;
  for (int cycle = 0; cycle < 20000; ++cycle) {
    watches.run(setup, drift.next());
    const PairEvents& truth = watches.told.events;
    for (const LinkPairIndex pair : watches.untold.events.settled) {
      ASSERT_EQ(truth.verdicts[pair], Verdict::warning) << cycle;
      const std::uint32_t closest = truth.closest[pair];
      ASSERT_NE(closest, kNone) << cycle;
      ASSERT_NE(closest, truth.closest_of_all) << cycle;
      const PairDistance& distance = watches.told.distances.pairs[closest];
      ASSERT_GE(scaleForPair(distance.measured.distance, distance.closing_speed, setup.ahead.stop),
                watches.told.memory.speed.scale - 1e-9)
          << cycle;
      ++settled;
    }
  }
  EXPECT_GT(settled, 1000) << "pairs are looked at, though nobody asks";
}

}  // namespace
}  // namespace collision_monitor::test::measure_told_laws
