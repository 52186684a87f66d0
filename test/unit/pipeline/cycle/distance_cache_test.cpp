// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/run_cycle.h"
#include "support/robots/hand_made_setup.h"

namespace collision_monitor {
namespace {

using test::handMadeSetup;
using test::kEighthTurn;
using test::knownPoses;

/// Two long boxes side by side, 0.4 m apart, turned so that their bounds meet and their bounding
/// spheres do, too. All rests as far as velocities say; 0.2 m are reported.
class LongBoxes : public testing::Test {
 protected:
  LongBoxes() {
    poses_.world_from_link[0].rotation = kEighthTurn;
    poses_.world_from_link[1] = {kEighthTurn, kEighthTurn * Eigen::Vector3d(0.0, 0.5, 0.0)};
    poses_.world_from_link[2].translation.x() = 50.0;
    std::fill(poses_.velocities.known.begin(), poses_.velocities.known.end(), 1);
    run();
  }
  void run() { runCycle(setup_, poses_, buffers_); }
  /// To one side along the boxes, and back in the next call.
  void shake(double travel) {
    side_ = -side_;
    poses_.world_from_link[1].translation += side_ * travel * kEighthTurn.col(0);
    run();
  }
  bool isMeasured() const { return !buffers_.candidates.empty(); }
  double travelOf(std::size_t body) const {
    return buffers_.memory.distance_cache.travels[body].all;
  }

  CycleSetup setup_ =
      handMadeSetup({{0, Box{{1.0, 0.05, 0.05}}}, {1, Box{{1.0, 0.05, 0.05}}}, {2, Sphere{0.1}}});
  CycleBuffers buffers_ = makeBuffers(setup_, BroadPhaseKind::brute_force);
  LinkPoses poses_ = knownPoses(setup_);

 private:
  double side_{-1.0};
};

TEST_F(LongBoxes, measuredOnce_thenNotUntilTheWaysHaveUsedUpTheGap) {
  EXPECT_TRUE(isMeasured());
  EXPECT_EQ(buffers_.counters.culled_by_cache, 0U);
  for (int i = 0; i < 3; ++i) {
    shake(0.05);
    EXPECT_FALSE(isMeasured()) << "0.4 m less " << 0.05 * (i + 1) << " m";
    EXPECT_EQ(buffers_.counters.culled_by_cache, 1U);
  }
  shake(0.05);
  EXPECT_TRUE(isMeasured()) << "0.4 m less four times 0.05 m and what rounds";
  shake(0.05);
  EXPECT_FALSE(isMeasured()) << "0.4 m once more";
}

TEST_F(LongBoxes, waysAreOfCenterAndTurn) {
  shake(0.05);
  EXPECT_EQ(travelOf(0), 0.0);
  EXPECT_NEAR(travelOf(1), 0.05, 1e-6);
  // Half a turn: two axes are turned round, which is 2 sqrt(2) in Frobenius' norm. The box is
  // bounded by a ball of sqrt(1 + 2 * 0.05^2) m.
  poses_.world_from_link[1].rotation.leftCols<2>() *= -1.0;
  run();
  EXPECT_NEAR(travelOf(1), 0.05 + std::sqrt(8.0 * 1.005), 1e-4);
  EXPECT_GE(travelOf(1), 0.05 + std::sqrt(8.0 * 1.005));
}

TEST_F(LongBoxes, linkThatWasLost_isMeasuredWhereverItComesBack) {
  shake(0.01);
  poses_.status[1] = LinkStatus::stale;
  run();
  poses_.world_from_link[1].translation.setZero();
  poses_.status[1] = LinkStatus::known;
  run();
  EXPECT_EQ(buffers_.events.verdicts[0], Verdict::contact);
}

TEST_F(LongBoxes, jumpOfAnyLength_isAWay) {
  shake(0.01);
  poses_.world_from_link[1].translation.setZero();
  run();
  EXPECT_EQ(buffers_.events.verdicts[0], Verdict::contact);
}

TEST_F(LongBoxes, waysThatGetLong_beginAnewAndWhatIsKnownStays) {
  shake(0.1);
  poses_.world_from_link[2].translation.x() = 1100.0;
  run();
  EXPECT_EQ(travelOf(1) + travelOf(2), 0.0);
  EXPECT_FALSE(isMeasured()) << "the boxes are 0.3 m apart as far as is known";
  shake(0.09);
  EXPECT_FALSE(isMeasured());
  shake(0.02);
  EXPECT_TRUE(isMeasured());
}

}  // namespace
}  // namespace collision_monitor
