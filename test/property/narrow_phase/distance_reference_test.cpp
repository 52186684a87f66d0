// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <tuple>

#include "narrow_phase/distance.h"
#include "support/expect_distance.h"
#include "support/fixed_seed.h"
#include "support/random_pairs.h"
#include "support/reference/reference_distance.h"

namespace collision_monitor::test {
namespace {

constexpr int kPairsPerCase = 250;

using Case = std::tuple<ShapeKind, ShapeKind, Nearness, Alignment>;

class AgainstReference : public testing::TestWithParam<Case> {};

TEST_P(AgainstReference, randomPairs_agreeWithin1e12) {
  const auto [kind_a, kind_b, nearness, alignment] = GetParam();
  for (const bool with_zero_lengths : {false, true}) {
    Random random(kSeed);
    const PairRecipe recipe{kind_a, kind_b, nearness, alignment, 1e-3, 5.0, with_zero_lengths};
    for (int i = 0; i < kPairsPerCase; ++i) {
      const ShapePair pair = randomPair(recipe, random);
      SCOPED_TRACE("seed " + std::to_string(kSeed) + ", pair " + std::to_string(i) + "\n" +
                   describe(pair));
      const SignedDistance found =
          distanceBetween(pair.a, pair.world_from_a, pair.b, pair.world_from_b);
      const Reference reference =
          referenceDistance(pair.a, pair.world_from_a, pair.b, pair.world_from_b);
      ASSERT_NEAR(found.distance, reference.distance, kExact);
      ASSERT_NEAR(signedDistanceTo(pair.a, inverse(pair.world_from_a) * found.point_on_a), 0.0,
                  kExact);
      ASSERT_NEAR(signedDistanceTo(pair.b, inverse(pair.world_from_b) * found.point_on_b), 0.0,
                  kExact);
      expectConsistent(found);
      ASSERT_FALSE(HasFailure());
    }
  }
}

std::string nameOfCase(const testing::TestParamInfo<Case>& info) {
  const auto [kind_a, kind_b, nearness, alignment] = info.param;
  return std::string(nameOf(kind_a)) + "_" + nameOf(kind_b) + "_" + nameOf(nearness) + "_" +
         nameOf(alignment);
}

INSTANTIATE_TEST_SUITE_P(AllPairs, AgainstReference,
                         testing::Combine(testing::ValuesIn(kShapeKinds),
                                          testing::ValuesIn(kShapeKinds),
                                          testing::ValuesIn(kNearnesses),
                                          testing::ValuesIn(kAlignments)),
                         nameOfCase);

// The reference has to be right on its own account: what it finds lies between a distance that
// two points have and a gap that a plane proves.
TEST(ReferenceDistance, randomPairsApart_certifyThemselves) {
  Random random(kSeed);
  for (const ShapeKind kind_a : kShapeKinds) {
    for (const ShapeKind kind_b : kShapeKinds) {
      for (int i = 0; i < kPairsPerCase; ++i) {
        const ShapePair pair =
            randomPair({kind_a, kind_b, Nearness::separated, Alignment::random}, random);
        const Reference reference =
            referenceDistance(pair.a, pair.world_from_a, pair.b, pair.world_from_b);
        EXPECT_LE(reference.certified_gap, 1e-14) << describe(pair);
      }
    }
  }
}

TEST(ReferenceDistance, unitCubes_handComputed) {
  const Shape cube = Box{{1, 1, 1}};
  EXPECT_EQ(referenceDistance(cube, Pose{}, cube, at(4, 4, 3)).distance, 3.0);
  EXPECT_EQ(referenceDistance(cube, Pose{}, cube, at(1.75, 0, 0)).distance, -0.25);
  EXPECT_EQ(referenceDistance(cube, Pose{}, cube, Pose{}).distance, -2.0);
}

TEST(ReferenceDistance, capsulesThatCross_depthIsSumOfRadii) {
  const Shape capsule = Capsule{1.0, 0.5};
  const Reference found = referenceDistance(capsule, Pose{}, capsule, {zToX(), {0.25, 0, 0}});
  EXPECT_EQ(found.distance, -1.0);
  EXPECT_EQ(std::abs(found.normal_a_to_b.y()), 1.0);
}

}  // namespace
}  // namespace collision_monitor::test
