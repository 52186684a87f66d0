// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>
#include <tuple>

#include "support/convex_cases.h"
#include "support/fixed_seed.h"
#include "support/reference/convex_measure.h"

// Convex pairs that move in small steps, each measured with what the last one left: every answer
// proves itself, and is that of a cold search.
namespace collision_monitor::test::convex_steps {
namespace {

constexpr std::size_t kPool = 12;
constexpr int kPairs = 30;
constexpr int kSteps = 25;

using Case = std::tuple<ConvexKind, ConvexKind, Nearness>;

class ConvexInSteps : public testing::TestWithParam<Case> {};
class ConvexThatTurns : public testing::TestWithParam<std::tuple<ConvexKind, ConvexKind>> {};

std::size_t anyBelow(std::size_t count, Random& random) {
  return std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
}

// Up to two degrees and 2 % of the lengths.
Pose smallStep(double length, Random& random) {
  const Eigen::Vector3d turn = randomPoint(random, 0.02);
  const double angle = turn.norm();
  const Eigen::Vector3d axis = turn.normalized();
  return {Eigen::AngleAxisd(angle, axis).toRotationMatrix(), randomPoint(random, 0.02 * length)};
}

void check(const PosedConvexPair& pair, const ConvexDistance& found, const ConvexDistance& cold) {
  const double size = 10.0 + extentOf(*pair.a) + extentOf(*pair.b);
  const double slack = found.measured.distance > 0.0 ? 1e-9 + 1e-11 * size : 1e-7;
  const ConvexCertificate proof = certify(pair, found.measured);
  ASSERT_LE(found.measured.distance, proof.gap_along_normal + slack) << describe(pair);
  if (found.quality == Quality::exact) {
    ASSERT_LE(proof.a_outside, 1e-6) << describe(pair);
    ASSERT_LE(proof.b_outside, 1e-6) << describe(pair);
    if (cold.quality == Quality::exact) {
      ASSERT_NEAR(found.measured.distance, cold.measured.distance, 2.0 * slack) << describe(pair);
    }
  }
}

// Of `length` zero the steps only turn.
void followInSteps(PosedConvexPair pair, double length, Random& random) {
  static ConvexWorkspace workspace;
  ConvexWarmStart warm;
  ConvexSearch search{workspace, warm};
  for (int step = 0; step < kSteps; ++step) {
    const ConvexDistance found =
        signedDistanceBetween(*pair.a, pair.world_from_a, *pair.b, pair.world_from_b, search);
    check(pair, found, measureCold(*pair.a, pair.world_from_a, *pair.b, pair.world_from_b));
    if (testing::Test::HasFatalFailure()) {
      return;
    }
    pair.world_from_b = pair.world_from_b * smallStep(length, random);
  }
}

// Hands pairs of two kinds to `follow`.
template <class Follow>
void forPairs(ConvexKind kind_a, ConvexKind kind_b, Nearness nearness, const Follow& follow) {
  Random random(kSeed);
  const ConvexPoolRecipe recipe{1e-2, 1.0, true};
  const std::vector<ConvexGeometry> pool_a = makeConvexPool(kind_a, kPool, recipe, random);
  const std::vector<ConvexGeometry> pool_b = makeConvexPool(kind_b, kPool, recipe, random);
  for (int i = 0; i < kPairs && !testing::Test::HasFatalFailure(); ++i) {
    const Alignment alignment = kAlignments[anyBelow(3, random)];
    follow(placeConvexPair(pool_a[anyBelow(kPool, random)], pool_b[anyBelow(kPool, random)],
                           nearness, alignment, random),
           random);
  }
}

TEST_P(ConvexInSteps, everyAnswer_isProvenAndThatOfAColdSearch) {
  const auto [kind_a, kind_b, nearness] = GetParam();
  forPairs(kind_a, kind_b, nearness, [](const PosedConvexPair& pair, Random& random) {
    followInSteps(pair, extentOf(*pair.a) + extentOf(*pair.b), random);
  });
}

// Opposite faces of the difference are equally far from a middle that both share.
TEST_P(ConvexThatTurns, aboutASharedMiddle_everyAnswerIsProvenToo) {
  const auto [kind_a, kind_b] = GetParam();
  forPairs(kind_a, kind_b, Nearness::overlapping, [](PosedConvexPair pair, Random& random) {
    pair.world_from_b.translation = pair.world_from_a.translation;
    followInSteps(pair, 0.0, random);
  });
}

constexpr ConvexKind kCores[] = {ConvexKind::sphere, ConvexKind::capsule, ConvexKind::box,
                                 ConvexKind::cylinder, ConvexKind::hull};

constexpr ConvexKind kOthers[] = {ConvexKind::cylinder, ConvexKind::hull, ConvexKind::box,
                                  ConvexKind::rounded_box};

std::string nameOfKinds(const testing::TestParamInfo<std::tuple<ConvexKind, ConvexKind>>& info) {
  return std::string(nameOf(std::get<0>(info.param))) + "_" + nameOf(std::get<1>(info.param));
}

std::string nameOfCase(const testing::TestParamInfo<Case>& info) {
  const auto [kind_a, kind_b, nearness] = info.param;
  return std::string(nameOf(kind_a)) + "_" + nameOf(kind_b) + "_" + nameOf(nearness);
}

INSTANTIATE_TEST_SUITE_P(AllPairs, ConvexInSteps,
                         testing::Combine(testing::ValuesIn(kOthers), testing::ValuesIn(kCores),
                                          testing::Values(Nearness::separated, Nearness::near,
                                                          Nearness::overlapping)),
                         nameOfCase);
INSTANTIATE_TEST_SUITE_P(AllPairs, ConvexThatTurns,
                         testing::Combine(testing::ValuesIn(kOthers), testing::ValuesIn(kCores)),
                         nameOfKinds);

}  // namespace
}  // namespace collision_monitor::test::convex_steps
