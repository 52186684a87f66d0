// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "collision_monitor/geometry/ids.h"
#include "listening_scene.h"
#include "pipeline/cycle/measure_told.h"

// What a cycle says does not depend on who listens.
namespace collision_monitor::test::measure_told_laws {
namespace {

void expectSame(double one, double other, double error, int cycle) {
  ASSERT_EQ(std::isnan(one), std::isnan(other)) << cycle;
  if (std::isfinite(one) || std::isfinite(other)) {
    ASSERT_NEAR(one, other, error) << cycle;
  }
}

const PairDistance* closestOf(const CycleBuffers& buffers, std::uint32_t place) {
  return place == kNone ? nullptr : &buffers.distances.pairs[place];
}

void expectSameIsSaid(const CycleSetup& setup, Drift drift) {
  Watches watches(setup);
  int compared = 0;
  for (int cycle = 0; cycle < 20000; ++cycle) {
    watches.run(setup, drift.next());
    const PairEvents& told = watches.told.events;
    const PairEvents& untold = watches.untold.events;
    ASSERT_EQ(told.verdicts, untold.verdicts) << cycle;
    ASSERT_EQ(told.changes.size(), untold.changes.size()) << cycle;
    const PairDistance* truth = closestOf(watches.told, told.closest_of_all);
    const PairDistance* found = closestOf(watches.untold, untold.closest_of_all);
    ASSERT_EQ(truth == nullptr, found == nullptr) << cycle;
    // Which way leads out of an overlap depends on where it was first met.
    if (truth == nullptr || isAnyEstimate(watches.told.distances)) {
      continue;
    }
    ASSERT_EQ(truth->quality, found->quality) << cycle;
    ASSERT_NEAR(truth->measured.distance, found->measured.distance, 1e-9) << cycle;
    expectSame(told.time_to_contact, untold.time_to_contact, 1e-5, cycle);
    expectSame(watches.told.memory.speed.scale, watches.untold.memory.speed.scale, 1e-5, cycle);
    ++compared;
  }
  EXPECT_GT(compared, 5000);
}

TEST(MeasureToldLaws, verdicts_nearest_timeAndScaleAreTheSame) {
  const CycleSetup setup = bodiesSetup();
  expectSameIsSaid(setup, Drift(setup));
}

TEST(MeasureToldLaws, manyWarnings_verdicts_nearest_timeAndScaleAreTheSame) {
  const CycleSetup setup = crowdedSetup();
  expectSameIsSaid(setup, Drift(setup, 0.1));
}

/// What is told has the same quality, and is the same up to the tolerance.
TEST(MeasureToldLaws, nearestWithATolerance_isAsExact) {
  constexpr double kTolerance = 1e-4;
  const CycleSetup setup = bodiesSetup();
  Watches watches(setup, kTolerance);
  Drift drift(setup);
  int compared = 0;
  for (int cycle = 0; cycle < 20000; ++cycle) {
    watches.run(setup, drift.next());
    ASSERT_EQ(watches.told.events.verdicts, watches.untold.events.verdicts) << cycle;
    const PairDistance* truth = closestOf(watches.told, watches.told.events.closest_of_all);
    const PairDistance* found = closestOf(watches.untold, watches.untold.events.closest_of_all);
    if (truth != nullptr && truth->quality == Quality::exact) {
      ASSERT_EQ(found->quality, Quality::exact) << cycle;
      ASSERT_NEAR(truth->measured.distance, found->measured.distance, kTolerance + 1e-9) << cycle;
      ++compared;
    }
  }
  EXPECT_GT(compared, 5000);
}

/// Distances that nobody is told are bounds, from below and from above.
TEST(MeasureToldLaws, whatIsNotMeasured_isBounded) {
  const CycleSetup setup = bodiesSetup();
  Watches watches(setup);
  Drift drift(setup);
  int spared = 0;
  int all = 0;
  for (int cycle = 0; cycle < 20000; ++cycle) {
    watches.run(setup, drift.next());
    for (std::size_t pair = 0; pair < setup.checked.size(); ++pair) {
      const PairDistance* truth = closestOf(watches.told, watches.told.events.closest[pair]);
      const PairDistance* found = closestOf(watches.untold, watches.untold.events.closest[pair]);
      if (truth == nullptr || found == nullptr || truth->quality != Quality::exact) {
        continue;
      }
      ++all;
      ASSERT_GE(truth->measured.distance, found->measured.distance - 1e-9) << cycle;
      if (found->shortfall > 0.0) {
        ++spared;
        ASSERT_EQ(found->quality, Quality::lower_bound) << cycle;
        ASSERT_LE(truth->measured.distance, found->measured.distance + found->shortfall + 1e-9)
            << cycle;
      }
    }
  }
  EXPECT_GT(spared, all / 20) << "pairs are measured, though nobody asks";
}

TEST(MeasureToldLaws, unknownVelocities_verdicts_nearest_timeAndScaleAreTheSame) {
  const CycleSetup setup = crowdedSetup();
  Drift drift(setup, 0.1);
  drift.hideVelocities();
  expectSameIsSaid(setup, drift);
}

/// Every second pair warns far away, the others near; what is reported reaches less far.
TEST(MeasureToldLaws, ownLimits_verdicts_nearest_timeAndScaleAreTheSame) {
  CycleSetup setup = crowdedSetup();
  setup.limits.report_distance = 0.06;
  setup.limits.warning_distance = 0.03;
  Limits wide = setup.limits;
  wide.report_distance = wide.warning_distance = 0.2;
  setup.own_limits.push_back({wide});
  for (std::size_t pair = 0; pair < setup.checked.size(); pair += 2) {
    setup.checked[pair].limits = 1;
  }
  expectSameIsSaid(setup, Drift(setup, 0.1));
}

/// Depths that nobody is told are those of contacts; the deepest is measured.
TEST(MeasureToldLaws, keptDepths_areOfContacts_andTheDeepestIsMeasured) {
  const CycleSetup setup = overlappingSetup();
  Watches watches(setup);
  Drift drift(setup, 1.0, 0.1);
  int kept = 0;
  double told_sum = 0.0;
  double untold_sum = 0.0;
  for (int cycle = 0; cycle < 20000; ++cycle) {
    watches.run(setup, drift.next());
    for (const PairDistance& found : watches.untold.distances.pairs) {
      if (found.quality == Quality::estimate && found.shortfall > 0.0) {
        const LinkPairIndex pair = setup.link_pair_of[index(found.pair)];
        ASSERT_EQ(watches.told.events.verdicts[pair], Verdict::contact) << cycle;
        ASSERT_LE(found.measured.distance + found.shortfall, 0.0) << cycle;
        ++kept;
      }
    }
    const PairDistance* truth = closestOf(watches.told, watches.told.events.closest_of_all);
    const PairDistance* found = closestOf(watches.untold, watches.untold.events.closest_of_all);
    if (truth != nullptr && truth->quality == Quality::estimate) {
      ASSERT_EQ(found->shortfall, 0.0) << cycle;
      told_sum += truth->measured.distance;
      untold_sum += found->measured.distance;
    }
  }
  EXPECT_GT(kept, 5000) << "depths are measured, though nobody asks";
  EXPECT_NEAR(untold_sum / told_sum, 1.0, 0.02);
}

/// A pair nearer than that is measured each time.
TEST(MeasureToldLaws, distancesBelowALimit_areTold) {
  const CycleSetup setup = bodiesSetup();
  Watches watches(setup);
  constexpr double kBelow = 0.04;
  std::fill(watches.untold.refine.told_below.begin(), watches.untold.refine.told_below.end(),
            kBelow);
  Drift drift(setup);
  int beyond = 0;
  for (int cycle = 0; cycle < 5000; ++cycle) {
    watches.run(setup, drift.next());
    for (const PairDistance& found : watches.untold.distances.pairs) {
      ASSERT_TRUE(found.shortfall == 0.0 || found.measured.distance >= kBelow) << cycle;
      beyond += found.shortfall > 0.0 ? 1 : 0;
    }
  }
  EXPECT_GT(beyond, 100);
}

}  // namespace
}  // namespace collision_monitor::test::measure_told_laws
