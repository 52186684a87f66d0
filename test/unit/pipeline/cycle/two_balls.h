// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/run_cycle.h"
#include "support/robots/hand_made_setup.h"

namespace collision_monitor::test {

/// Two balls of radius 0.1 m beside each other along x, each on a link of its own, and their
/// cycles; limits 0 / 0.05 / 0.005 / 0.2 m, 0 / 0.1 / 0.05 s; horizon 0.5 s, stop at 0.01 m in
/// 0.25 s.
class TwoBalls : public testing::Test {
 protected:
  /// Velocities are as they were: at first unknown.
  void runWithGap(double gap) {
    poses_.world_from_link[1].translation.x() = 0.2 + gap;
    runCycle(setup_, poses_, buffers_);
  }
  /// 10 ms after the last one, the second ball coming nearer at `closing`.
  void runWithGap(double gap, double closing) {
    setVelocity(0, 0.0);
    setVelocity(1, -closing);
    poses_.stamp_ns += 10'000'000;
    runWithGap(gap);
  }
  void setVelocity(std::size_t link, double along_x) {
    poses_.velocities.of_link[link] = {Eigen::Vector3d(along_x, 0, 0), Eigen::Vector3d::Zero()};
    poses_.velocities.known[link] = 1;
  }
  const PairDistance& nearest() const {
    return buffers_.distances.pairs.at(buffers_.events.closest[0]);
  }
  Verdict verdict() const { return buffers_.events.verdicts[0]; }
  double scale() const { return buffers_.memory.speed.scale; }

  CycleSetup setup_ = handMadeSetup({{0, Sphere{0.1}}, {1, Sphere{0.1}}});
  CycleBuffers buffers_ = makeBuffers(setup_, BroadPhaseKind::brute_force);
  LinkPoses poses_ = knownPoses(setup_);
};

/// Three such balls, all at rest.
class ThreeBalls : public TwoBalls {
 protected:
  ThreeBalls() {
    setup_ = handMadeSetup({{0, Sphere{0.1}}, {1, Sphere{0.1}}, {2, Sphere{0.1}}});
    buffers_ = makeBuffers(setup_, BroadPhaseKind::brute_force);
    poses_ = knownPoses(setup_);
    poses_.velocities.known = {1, 1, 1};
  }
};

}  // namespace collision_monitor::test
