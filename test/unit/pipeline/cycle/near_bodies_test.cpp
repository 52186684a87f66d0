// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/cycle/near_bodies.h"

#include <gtest/gtest.h>

#include "collision_monitor/geometry/ids.h"
#include "pipeline/cycle/measure_pairs.h"
#include "pipeline/cycle/run_cycle.h"
#include "pipeline/look_ahead/find_closings.h"
#include "support/fixed_seed.h"
#include "support/random_poses.h"
#include "support/robots/geometry_setup.h"
#include "support/robots/hand_made_setup.h"

namespace collision_monitor::test::near_bodies {
namespace {

CycleSetup longAndShortSetup() {
  return geometrySetup({Box{{0.2, 0.02, 0.01}}, Sphere{0.05}, Box{{0.02, 0.3, 0.02}}}, {});
}

/// Random velocities; every second link turns about its own origin.
void turn(Random& random, LinkPoses& poses) {
  for (std::size_t link = 0; link < poses.status.size(); ++link) {
    const Eigen::Vector3d spin = randomPoint(random, 5.0);
    const Eigen::Vector3d linear =
        link % 2 == 0 ? randomPoint(random, 1.0) : Eigen::Vector3d(Eigen::Vector3d::Zero());
    poses.velocities.of_link[link] = {linear - spin.cross(poses.world_from_link[link].translation),
                                      spin};
    poses.velocities.known[link] = 1;
  }
}

TEST(NearBodies, closingSpeed_isNotLessThanOfWitnessPoints) {
  const CycleSetup setup = longAndShortSetup();
  CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::brute_force);
  const std::vector<PairId> all = {PairId{0}, PairId{1}, PairId{2}};
  Random random(kSeed);
  double largest_share = 0.0;
  for (unsigned i = 0; i < 2000; ++i) {
    LinkPoses poses = randomLinkPoses(setup, 0.5, kSeed + i);
    turn(random, poses);
    runCycle(setup, poses, buffers);
    measurePairs(setup, buffers.body_poses, all, buffers.distances);
    findClosings(setup, poses, buffers.distances);
    const NearBodies near = nearBodies(setup, poses, buffers);
    for (const PairDistance& pair : buffers.distances.pairs) {
      if (pair.measured.distance > 0.0) {
        const ElementsPlace place = near.placeOf(pair.pair);
        const double bound = near.closingSpeed(place, near.closingOf(place));
        EXPECT_LE(pair.closing_speed, bound + 1e-9);
        largest_share = std::max(largest_share, pair.closing_speed / bound);
      }
    }
  }
  EXPECT_GT(largest_share, 0.8);  // and it is not much more
}

TEST(NearBodies, closingSpeed_whereAVelocityIsUnknown_isNotFinite) {
  const CycleSetup setup = longAndShortSetup();
  CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::brute_force);
  LinkPoses poses = randomLinkPoses(setup, 0.5, kSeed);
  poses.velocities.known.assign(poses.velocities.known.size(), 1);
  poses.velocities.known[1] = 0;
  runCycle(setup, poses, buffers);
  const NearBodies near = nearBodies(setup, poses, buffers);
  for (std::uint32_t i = 0; i < 3; ++i) {
    const ElementsPlace place = near.placeOf(PairId{i});
    const BodyPair& pair = setup.table[PairId{i}];
    const bool is_known = index(setup.bodies[index(pair.a)].link) != 1 &&
                          index(setup.bodies[index(pair.b)].link) != 1;
    EXPECT_EQ(std::isfinite(near.closingSpeed(place, near.closingOf(place))), is_known);
  }
}

}  // namespace
}  // namespace collision_monitor::test::near_bodies
