// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "collision_monitor/geometry/ids.h"
#include "collision_monitor/motion/speed_scale.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/measure_told.h"
#include "pipeline/cycle/run_cycle.h"
#include "support/fixed_seed.h"
#include "support/query_meshes.h"
#include "support/random_poses.h"
#include "support/robots/geometry_setup.h"
#include "support/robots/hand_made_setup.h"
#include "support/sample_meshes.h"

// What a cycle says does not depend on who listens.
namespace collision_monitor::test::measure_told_laws {
namespace {

constexpr std::uint32_t kAmple = 10000000;
constexpr std::int64_t kPeriod = 1000000;  // [ns]

CycleSetup bodiesSetup() {
  SetupOptions options;
  options.default_limits.max_shapes = 2;
  CycleSetup setup = geometrySetup({bumpyMesh(0.2, 16), angleMesh(), Cylinder{0.1, 0.05},
                                    Box{{0.1, 0.04, 0.03}}, bumpyMesh(0.1, 12)},
                                   options);
  setup.refine.budget = kAmple;
  setup.ahead.stop.release_time = 1e-9;  // no scale depends on earlier ones
  return setup;
}

/// With many warnings.
CycleSetup crowdedSetup() {
  CycleSetup setup = bodiesSetup();
  setup.limits.warning_distance = 0.15;
  return setup;
}

/// Moves each link evenly for a while, then throws it somewhere else.
class Drift {
 public:
  /// @param speed [m/s] [rad/s] at most
  explicit Drift(const CycleSetup& setup, double speed = 1.0)
      : speed_(speed), poses_(randomLinkPoses(setup, 0.25, kSeed)), random_(kSeed) {
    poses_.stamp_ns = kPeriod;
    for (std::size_t link = 0; link < poses_.status.size(); ++link) {
      turn(link);
    }
  }

  /// Velocities are now and then unknown for a while.
  void hideVelocities() { hides_velocities_ = true; }

  const LinkPoses& next() {
    poses_.stamp_ns += kPeriod;
    for (std::size_t link = 0; link < poses_.status.size(); ++link) {
      if (random_() % 500 == 0) {
        poses_.world_from_link[link] = randomPose(random_, 0.25);
        turn(link);
      }
      move(poses_.velocities.of_link[link], poses_.world_from_link[link]);
      if (hides_velocities_ && random_() % 200 == 0) {
        poses_.velocities.known[link] = random_() % 4 == 0 ? 0 : 1;
      }
    }
    return poses_;
  }

 private:
  static void move(const Twist& twist, Pose& pose) {
    constexpr double kSeconds = 1e-9 * static_cast<double>(kPeriod);
    const double angle = kSeconds * twist.angular.norm();
    const Eigen::Matrix3d turned =
        Eigen::AngleAxisd(angle, twist.angular.normalized()).toRotationMatrix();
    pose.rotation = turned * pose.rotation;
    pose.translation = turned * pose.translation + kSeconds * twist.linear;
  }
  void turn(std::size_t link) {
    poses_.velocities.of_link[link] = {randomPoint(random_, 0.2 * speed_),
                                       randomPoint(random_, speed_)};
    poses_.velocities.known[link] = 1;
  }

  double speed_;
  bool hides_velocities_{false};
  LinkPoses poses_;
  Random random_;
};

struct Watches {
  explicit Watches(const CycleSetup& setup, double tolerance = 0.0)
      : told(makeBuffers(setup, BroadPhaseKind::brute_force)),
        untold(makeBuffers(setup, BroadPhaseKind::brute_force)) {
    told.refine.limits.tolerance = untold.refine.limits.tolerance = tolerance;
    untold.refine.tells_all = false;
  }
  void run(const CycleSetup& setup, const LinkPoses& poses) {
    runCycle(setup, poses, told);
    runCycle(setup, poses, untold);
  }

  CycleBuffers told;
  CycleBuffers untold;
};

void expectSame(double one, double other, double error, int cycle) {
  ASSERT_EQ(std::isnan(one), std::isnan(other)) << cycle;
  if (std::isfinite(one) || std::isfinite(other)) {
    ASSERT_NEAR(one, other, error) << cycle;
  }
}

const PairDistance* closestOf(const CycleBuffers& buffers, std::uint32_t place) {
  return place == kNone ? nullptr : &buffers.distances.pairs[place];
}

bool isAnyEstimate(const PairDistances& distances) {
  return std::any_of(distances.pairs.begin(), distances.pairs.end(),
                     [](const PairDistance& pair) { return pair.quality == Quality::estimate; });
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
  EXPECT_GT(spared, all / 6) << "pairs are measured, though nobody asks";
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

TEST(MeasureToldLaws, warningThatEnds_hasADistance) {
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

/// Where nobody listens, a robot that was slowed down is set free at the same time or later.
TEST(MeasureToldLaws, scaleThatGrows_isNeverLarger) {
  CycleSetup setup = crowdedSetup();
  setup.ahead.stop.release_time = 0.1;
  Watches watches(setup);
  Drift drift(setup, 0.1);
  int growing = 0;
  int later = 0;
  for (int cycle = 0; cycle < 20000; ++cycle) {
    const double before = watches.told.memory.speed.scale;
    watches.run(setup, drift.next());
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
TEST(MeasureToldLaws, settledPairs_areWarnings_andOthersSayLess) {
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
