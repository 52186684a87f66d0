// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstdlib>

#include "support/convex_measure.h"
#include "support/random_motions.h"

namespace collision_monitor::test {
namespace {

constexpr unsigned kSeed = 20260101;

int countFrom(const char* variable, int otherwise) {
  const char* text = std::getenv(variable);
  return text != nullptr ? std::atoi(text) : otherwise;
}

double distanceAt(const PlateCrossing& scene, double time) {
  return measureCold(scene.plate, poseAt(scene.still, time), scene.body,
                     poseAt(scene.crossing, time))
      .measured.distance;
}

/// The environment variable COLLISION_MONITOR_CROSSINGS asks for more; scripts/figures motion does.
TEST(PlateCrossing, everyCrossingIsCaught_whereTheBodiesAreNear) {
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  Random random(kSeed);
  const int count = countFrom("COLLISION_MONITOR_CROSSINGS", 5000);
  int caught = 0;
  double farthest = 0.0;
  for (int i = 0; i < count; ++i) {
    const PlateCrossing scene = randomCrossing(random);
    const SweptContact found = meetConvex(scene.plate, scene.still, scene.body, scene.crossing);
    caught += found.state == SweepState::contact ? 1 : 0;
    farthest = std::max(farthest, distanceAt(scene, found.time));
  }
  EXPECT_EQ(caught, count);
  EXPECT_LE(farthest, 1e-6);
  RecordProperty("caught", caught);
}

TEST(PlateCrossing, tenThousandSteps_showNoContactBeforeTheTime) {
  SCOPED_TRACE(testing::Message() << "seed " << kSeed + 1);
  Random random(kSeed + 1);
  constexpr int kSteps = 10000;
  const int count = countFrom("COLLISION_MONITOR_SUBDIVISIONS", 10);
  for (int i = 0; i < count; ++i) {
    const PlateCrossing scene = randomCrossing(random);
    const SweptContact found = meetConvex(scene.plate, scene.still, scene.body, scene.crossing);
    ASSERT_EQ(found.state, SweepState::contact);
    // A cycle of 20 ms: 1e-6 s are 5e-5 of it.
    for (int step = 0; step < kSteps; ++step) {
      const double time = static_cast<double>(step) / kSteps;
      if (time >= found.time - 5e-5) {
        break;
      }
      ASSERT_GT(distanceAt(scene, time), 0.0) << "crossing " << i << " at " << time;
    }
  }
}

}  // namespace
}  // namespace collision_monitor::test
