// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cstring>
#include <limits>
#include <random>

#include "narrow_phase/convex/convex_pairs.h"
#include "support/convex_cases.h"
#include "support/fixed_seed.h"
#include "support/instruction_sets.h"

// Many pairs by one call: every answer, and what is left for the next search, is that of the call
// for one pair, to the last bit and on every instruction set.
namespace collision_monitor::test {
namespace {

constexpr std::size_t kPool = 8;
constexpr int kSteps = 12;
constexpr ConvexKind kKinds[] = {ConvexKind::hull,        ConvexKind::cylinder, ConvexKind::box,
                                 ConvexKind::rounded_box, ConvexKind::capsule,  ConvexKind::sphere,
                                 ConvexKind::half_space};

// Every two kinds in every nearness and alignment, with a hull twice as often.
struct Scene {
  std::vector<std::vector<ConvexGeometry>> pools;
  std::vector<PosedConvexPair> pairs;
  std::vector<ConvexWarmStart> warm_alone;
  std::vector<ConvexWarmStart> warm_together;
};

const ConvexGeometry& anyOf(const std::vector<ConvexGeometry>& pool, Random& random) {
  return pool[std::uniform_int_distribution<std::size_t>(0, pool.size() - 1)(random)];
}

Scene makeScene(Random& random) {
  Scene scene;
  for (const ConvexKind kind : kKinds) {
    scene.pools.push_back(makeConvexPool(kind, kPool, {1e-2, 1.0, true}, random));
  }
  for (const Nearness nearness : {Nearness::separated, Nearness::near, Nearness::overlapping}) {
    for (const Alignment alignment : kAlignments) {
      for (std::size_t a = 0; a < scene.pools.size(); ++a) {
        for (std::size_t b = 0; b < scene.pools.size(); ++b) {
          const int count = a == 0 || b == 0 ? 8 : 4;
          for (int i = 0; i < count; ++i) {
            scene.pairs.push_back(placeConvexPair(anyOf(scene.pools[a], random),
                                                  anyOf(scene.pools[b], random), nearness,
                                                  alignment, random));
          }
        }
      }
    }
  }
  scene.warm_alone.resize(scene.pairs.size());
  scene.warm_together.resize(scene.pairs.size());
  return scene;
}

// Some stand still, some slide along themselves, most turn, too; a few are lost for a while.
Pose moved(const Pose& pose, double length, int step, std::size_t pair, Random& random) {
  Pose next = pose;
  if (pair % 7 != 0) {
    next.translation += randomPoint(random, 0.01 * length);
  }
  if (pair % 3 != 0) {
    const Eigen::Vector3d turn = randomPoint(random, 0.02);
    next.rotation =
        Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix() * pose.rotation;
  }
  if (step == kSteps / 2 && pair % 11 == 0) {
    next.translation.y() = std::numeric_limits<double>::quiet_NaN();
  }
  return next;
}

bool isSame(const ConvexWarmStart& one, const ConvexWarmStart& other) {
  return one.size == other.size && one.vertex_of_a == other.vertex_of_a &&
         one.vertex_of_b == other.vertex_of_b && one.polytope_faces == other.polytope_faces &&
         std::memcmp(one.ends.data(), other.ends.data(), one.size * sizeof(one.ends[0])) == 0;
}

void compareAll(Scene& scene, const std::vector<Pose>& world_from_b) {
  static ConvexWorkspace workspace;
  std::vector<ConvexQuery> queries;
  for (std::size_t i = 0; i < scene.pairs.size(); ++i) {
    const PosedConvexPair& pair = scene.pairs[i];
    queries.push_back(
        {pair.a, &pair.world_from_a, pair.b, &world_from_b[i], &scene.warm_together[i]});
  }
  std::vector<ConvexDistance> answers(queries.size());
  signedDistancesBetween(queries.data(), queries.size(), workspace, answers.data());
  for (std::size_t i = 0; i < queries.size(); ++i) {
    ConvexSearch search{workspace, scene.warm_alone[i]};
    const ConvexDistance alone = signedDistanceBetween(
        *queries[i].a, *queries[i].world_from_a, *queries[i].b, *queries[i].world_from_b, search);
    ASSERT_EQ(answers[i].quality, alone.quality) << describe(scene.pairs[i]);
    ASSERT_EQ(std::memcmp(&answers[i].measured, &alone.measured, sizeof(SignedDistance)), 0)
        << describe(scene.pairs[i]) << answers[i].measured.distance - alone.measured.distance;
    ASSERT_TRUE(isSame(scene.warm_together[i], scene.warm_alone[i])) << describe(scene.pairs[i]);
  }
}

TEST(ConvexPairsLaws, manyAtOnce_areTheSameBytesAsOneByOne) {
  for (const std::int64_t target : instructionSets()) {
    const OnlyInstructionSet only(target);
    Random random(kSeed);
    Scene scene = makeScene(random);
    std::vector<Pose> world_from_b;
    for (int step = 0; step < kSteps; ++step) {
      world_from_b.clear();
      for (std::size_t i = 0; i < scene.pairs.size(); ++i) {
        PosedConvexPair& pair = scene.pairs[i];
        const double length = extentOf(*pair.a);
        world_from_b.push_back(moved(pair.world_from_b, length, step, i, random));
        pair.world_from_b = isFinite(world_from_b[i]) ? world_from_b[i] : pair.world_from_b;
      }
      compareAll(scene, world_from_b);
      ASSERT_FALSE(HasFatalFailure()) << hwy::TargetName(target) << ", step " << step;
    }
  }
}

TEST(ConvexPairsLaws, noPairs_touchNothing) {
  static ConvexWorkspace workspace;
  ConvexDistance answer;
  answer.measured.distance = 7.0;
  signedDistancesBetween(nullptr, 0, workspace, &answer);
  EXPECT_EQ(answer.measured.distance, 7.0);
}

}  // namespace
}  // namespace collision_monitor::test
