// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/fixed_seed.h"
#include "support/robots/random_motions.h"

namespace collision_monitor::test {
namespace {

constexpr int kSteps = 10000;

/// Of the way: 1e-6 s of a cycle of 20 ms.
constexpr double kMoment = 1e-6 / 0.02;
TEST(PlateCrossing, everyCrossingIsCaught_whereTheBodiesAreNear) {
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  Random random(kSeed);
  constexpr int kCount = 5000;
  int caught = 0;
  double farthest = 0.0;
  for (int i = 0; i < kCount; ++i) {
    const PlateCrossing scene = randomCrossing(random);
    const SweptContact found = meetConvex(scene.plate, scene.still, scene.body, scene.crossing);
    caught += found.state == SweepState::contact ? 1 : 0;
    farthest = std::max(farthest, distanceAt(scene, found.time));
  }
  EXPECT_EQ(caught, kCount);
  EXPECT_LE(farthest, 1e-6);
}

TEST(PlateCrossing, firstOverlap_isThatOfEveryStep) {
  SCOPED_TRACE(testing::Message() << "seed " << kSeed + 1);
  Random random(kSeed + 1);
  for (int i = 0; i < 10; ++i) {
    const PlateCrossing scene = randomCrossing(random, i % 2 == 0 ? 0.3 : 0.06);
    EXPECT_TRUE(isAsEveryStepShows(scene, kSteps)) << "crossing " << i;
  }
}

TEST(PlateCrossing, tenThousandSteps_showTheContactsThatAreTold) {
  SCOPED_TRACE(testing::Message() << "seed " << kSeed + 2);
  Random random(kSeed + 2);
  int contacts = 0;
  int passes = 0;
  for (int i = 0; i < 2000; ++i) {
    const PlateCrossing scene = randomCrossing(random, 0.06);
    const SweptContact found = meetConvex(scene.plate, scene.still, scene.body, scene.crossing);
    const std::optional<int> shown = firstOverlap(scene, kSteps);
    ++(shown ? contacts : passes);
    if (shown) {
      ASSERT_EQ(found.state, SweepState::contact) << "crossing " << i;
      ASSERT_LE(found.time, static_cast<double>(*shown) / kSteps + kMoment) << "crossing " << i;
    }
    if (found.state == SweepState::contact) {
      ASSERT_LE(distanceAt(scene, found.time), 1e-6) << "crossing " << i;
    }
  }
  EXPECT_GT(contacts, 300);
  EXPECT_GT(passes, 300);
}

}  // namespace
}  // namespace collision_monitor::test
