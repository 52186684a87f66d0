// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/reference/convex_reference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <tuple>

#include "support/convex_cases.h"
#include "support/fixed_seed.h"

// Convex pairs against the slow reference, and against what proves an answer by itself. Prints the
// worst errors, which docs/accuracy.md shows.
namespace collision_monitor::test::convex_reference {
namespace {

constexpr std::size_t kPool = 16;

using Case = std::tuple<ConvexKind, ConvexKind, Nearness>;

class ConvexAgainstReference : public testing::TestWithParam<Case> {};

struct Worst {
  double error{0.0};
  double gap_error{0.0};
  double outside{0.0};
  int bounds{0};
};

/// A question that stands alone is answered with fewer steps.
ConvexDistance measureAlone(const PosedConvexPair& pair) {
  static ConvexWorkspace workspace;
  ConvexWarmStart warm;
  ConvexSearch search{workspace, warm};
  search.stands_alone = true;
  return signedDistanceBetween(*pair.a, pair.world_from_a, *pair.b, pair.world_from_b, search);
}

void check(const PosedConvexPair& pair, Worst& worst) {
  static ConvexWorkspace workspace;
  ConvexWarmStart warm;
  ConvexSearch search{workspace, warm};
  const ConvexDistance answer =
      signedDistanceBetween(*pair.a, pair.world_from_a, *pair.b, pair.world_from_b, search);
  const double found = answer.measured.distance;
  const ConvexCertificate proof = certify(pair, answer.measured);
  worst.gap_error = std::max(worst.gap_error, std::abs(found - proof.gap_along_normal));
  long double reference = 0;
  if (convexReference(pair, reference)) {
    worst.error = std::max(worst.error, std::abs(found - static_cast<double>(reference)));
    // Two cylinders: the reference comes from below, and what is above it is proven by its normal.
    const bool are_cylinders =
        std::holds_alternative<Cylinder>(*pair.a) && std::holds_alternative<Cylinder>(*pair.b);
    const bool is_bound = answer.quality == Quality::lower_bound;
    const double above = are_cylinders ? 1e-6 : 1e-9;
    const double below = is_bound ? 1e-6 : found > 0.0 ? 1e-9 : 1e-7;
    ASSERT_LE(found, static_cast<double>(reference) + above) << describe(pair);
    ASSERT_GE(found, static_cast<double>(reference) - below) << describe(pair);
  }
  const ConvexDistance alone = measureAlone(pair);
  if (answer.quality == Quality::exact && alone.quality == Quality::exact) {
    ASSERT_NEAR(alone.measured.distance, found, found > 0.0 ? 1e-9 : 1e-7) << describe(pair);
  }
  if (answer.quality == Quality::exact) {
    worst.outside = std::max({worst.outside, proof.a_outside, proof.b_outside});
  } else {
    ++worst.bounds;
  }
}

TEST_P(ConvexAgainstReference, randomPairs_agree) {
  const auto [kind_a, kind_b, nearness] = GetParam();
  const bool is_slow = kind_a == ConvexKind::cylinder || kind_b == ConvexKind::cylinder;
  Random random(kSeed);
  const ConvexPoolRecipe recipe{0.01, 1.0, false};
  const auto pool_a = makeConvexPool(kind_a, kPool, recipe, random);
  const auto pool_b = makeConvexPool(kind_b, kPool, recipe, random);
  Worst worst;
  const int count = is_slow ? 12 : 48;
  for (int i = 0; i < count; ++i) {
    const PosedConvexPair pair =
        placeConvexPair(pool_a[random() % kPool], pool_b[random() % kPool], nearness,
                        kAlignments[static_cast<std::size_t>(i) % 3], random);
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", pair " + std::to_string(i));
    check(pair, worst);
    ASSERT_FALSE(HasFatalFailure());
  }
  EXPECT_LE(worst.gap_error, 2e-9);
  std::printf("| %s-%s | %s | %.1e | %.1e | %.1e | %d |\n", nameOf(kind_a), nameOf(kind_b),
              nameOf(nearness), worst.error, worst.gap_error, std::max(worst.outside, 0.0),
              worst.bounds);
}

std::string nameOfCase(const testing::TestParamInfo<Case>& info) {
  const auto [kind_a, kind_b, nearness] = info.param;
  return std::string(nameOf(kind_a)) + "_" + nameOf(kind_b) + "_" + nameOf(nearness);
}

constexpr ConvexKind kNewKinds[] = {ConvexKind::cylinder, ConvexKind::hull};
constexpr ConvexKind kPartners[] = {ConvexKind::sphere,   ConvexKind::capsule,
                                    ConvexKind::box,      ConvexKind::rounded_box,
                                    ConvexKind::cylinder, ConvexKind::hull};

INSTANTIATE_TEST_SUITE_P(AllPairs, ConvexAgainstReference,
                         testing::Combine(testing::ValuesIn(kPartners),
                                          testing::ValuesIn(kNewKinds),
                                          testing::ValuesIn(kNearnesses)),
                         nameOfCase);

}  // namespace
}  // namespace collision_monitor::test::convex_reference
