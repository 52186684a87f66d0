// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>

#include "collision_monitor/geometry/ids.h"
#include "pipeline/answers/link_distances.h"
#include "pipeline/cycle/run_cycle.h"
#include "support/query_meshes.h"
#include "support/robots/geometry_setup.h"
#include "support/robots/hand_made_setup.h"

// Two elements of two links overlapped by an exact 20 mm, and a box of 0.1 m stood in the middle of
// a mesh beside them. The depth of the links was told as exactly 20 mm.
namespace collision_monitor::test {
namespace {

CollisionElement elementAt(const Geometry& geometry, double x) {
  CollisionElement element;
  element.geometry = geometry;
  element.link_from_geometry.translation.x() = x;
  return element;
}

class DepthOfSeveralElements : public testing::Test {
 protected:
  const Box box_{{0.05, 0.05, 0.05}};
  CycleSetup setup_ = linkSetup({{elementAt(bumpyMesh(0.2, 8), 0.0), elementAt(box_, 2.0)},
                                 {elementAt(box_, 0.0), elementAt(box_, 2.08)}},
                                SetupOptions());
  LinkPoses poses_ = knownPoses(setup_);
};

TEST_F(DepthOfSeveralElements, toldByACycle_isAnEstimate) {
  CycleBuffers buffers = makeBuffers(setup_, BroadPhaseKind::brute_force);
  for (int cycle = 0; cycle < 3; ++cycle) {
    poses_.stamp_ns += 1'000'000;
    runCycle(setup_, poses_, buffers);
    const PairDistance& closest = buffers.distances.pairs[buffers.events.closest[0]];
    EXPECT_NEAR(closest.measured.distance, -0.02, 1e-9);
    EXPECT_EQ(closest.quality, Quality::estimate);
    EXPECT_EQ(buffers.events.overall, Verdict::contact);
  }
}

TEST_F(DepthOfSeveralElements, askedFor_isAnEstimate) {
  LinkDistances links = makeLinkDistances(setup_);
  for (std::size_t i = 0; i < setup_.table.size(); ++i) {
    links.candidates.push_back(idAt<PairId>(i));
  }
  placeAll(setup_, poses_, links);
  measureWithin(setup_, std::numeric_limits<double>::infinity(), Asked::within, links);
  EXPECT_NEAR(links.of(0).measured.distance, -0.02, 1e-9);
  EXPECT_EQ(links.of(0).quality, Quality::estimate);
}

}  // namespace
}  // namespace collision_monitor::test
