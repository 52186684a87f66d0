// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "narrow_phase/distance.h"
#include "pipeline/blocks/contact_of_pairs.h"
#include "pipeline/cycle/place_bodies.h"
#include "support/fixed_seed.h"
#include "support/instruction_sets.h"
#include "support/robots/hand_made_setup.h"

namespace collision_monitor::test::pair_blocks_laws {
namespace {

struct Scene {
  const CycleSetup& setup;
  const BodyPoses& body_poses;
};

void expectNearest(const Scene& scene, const std::vector<double>& distances) {
  const CycleSetup& setup = scene.setup;
  NearestPair nearest;
  searchBlocks(setup.blocks, scene.body_poses.rows,
               {setup.element_pair_of, std::vector<unsigned char>(setup.element_pairs.size(), 0)},
               nearest);
  const auto least = std::min_element(distances.begin(), distances.end());
  ASSERT_EQ(nearest.distance, *least);
  ASSERT_EQ(index(nearest.pair), static_cast<std::size_t>(least - distances.begin()));
}

void expectFirstContact(const Scene& scene, const std::vector<double>& distances,
                        std::size_t& contacts) {
  const CycleSetup& setup = scene.setup;
  FoundContact found;
  findContact(setup.blocks, scene.body_poses.rows, contactDistancesOf(setup), found);
  const auto touching = std::find_if(distances.begin(), distances.end(),
                                     [](double distance) { return distance <= 0.0; });
  ASSERT_EQ(found.contact.distance,
            touching == distances.end() ? std::numeric_limits<double>::infinity() : *touching);
  contacts += touching == distances.end() ? 0 : 1;
}

void expectPlainDistances(const Scene& scene, const std::vector<double>& distances) {
  const CycleSetup& setup = scene.setup;
  const auto& world_from_body = scene.body_poses.world_from_body;
  for (std::size_t i = 0; i < setup.table.size(); ++i) {
    const std::size_t a = index(setup.table.pairs()[i].a);
    const std::size_t b = index(setup.table.pairs()[i].b);
    ASSERT_NEAR(distances[i],
                distanceBetween(setup.bodies[a].shape, world_from_body[a], setup.bodies[b].shape,
                                world_from_body[b])
                    .distance,
                1e-12);
  }
}

/// The same bytes as among all distances, in the order of the table.
void expectNear(const Scene& scene, const std::vector<double>& distances, double within,
                std::size_t& left_out) {
  std::vector<NearestPair> near;
  findNear(scene.setup.blocks, scene.body_poses.rows, within, near);
  std::size_t next = 0;
  for (std::size_t i = 0; i < distances.size(); ++i) {
    if (distances[i] <= within) {
      ASSERT_LT(next, near.size());
      ASSERT_EQ(index(near[next].pair), i);
      ASSERT_EQ(near[next].distance, distances[i]);
      ++next;
    }
  }
  ASSERT_EQ(next, near.size());
  left_out += distances.size() - next;
}

/// The same bytes on every instruction set, and the plain twin's distances.
void expectLaws(const Scene& scene, std::size_t& contacts, std::size_t& left_out) {
  std::vector<double> first;
  for (const std::int64_t target : instructionSets()) {
    SCOPED_TRACE(hwy::TargetName(target));
    const OnlyInstructionSet only(target);
    const std::vector<double> distances = allDistances(scene.setup, scene.body_poses.rows);
    ASSERT_TRUE(first.empty() ||
                std::memcmp(first.data(), distances.data(), first.size() * sizeof(double)) == 0);
    first = distances;
    ASSERT_NO_FATAL_FAILURE(expectNearest(scene, distances));
    ASSERT_NO_FATAL_FAILURE(expectFirstContact(scene, distances, contacts));
    ASSERT_NO_FATAL_FAILURE(expectNear(scene, distances, 0.3, left_out));
  }
  expectPlainDistances(scene, first);
}

TEST(PairBlocksLaws, distancesAndNearestPairAreThoseOfThePlainTwin_onEveryInstructionSet) {
  std::size_t contacts = 0;
  std::size_t left_out = 0;
  for (unsigned round = 0; round < 200; ++round) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed + round);
    const CycleSetup setup = randomSetup(2 + round % 20, kSeed + round);
    const LinkPoses poses = randomLinkPoses(setup, round % 2 == 0 ? 0.4 : 4.0, kSeed + round);
    BodyPoses body_poses = makeBodyPoses(setup);
    placeBodies(setup, poses, body_poses);
    ASSERT_NO_FATAL_FAILURE(expectLaws({setup, body_poses}, contacts, left_out));
  }
  EXPECT_GT(contacts, 100U);
  EXPECT_GT(left_out, 100U);
}

}  // namespace
}  // namespace collision_monitor::test::pair_blocks_laws
