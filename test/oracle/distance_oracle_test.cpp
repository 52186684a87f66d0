// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "narrow_phase/distance.h"
#include "support/expect_distance.h"
#include "support/fixed_seed.h"
#include "support/random_pairs.h"
#include "support/reference/reference_distance.h"
#include "support_fcl/fcl_adapter.h"

// Prints the tables of docs/accuracy.md: for each kind of pair the worst error of this package
// and of FCL against the exact reference.
namespace collision_monitor::test::distance_oracle {
namespace {

constexpr int kPairsPerRow = 4096;
// FCL's booleans are compared where the answer is not a matter of rounding.
constexpr double kDecided = 1e-6;

struct Worst {
  double ours{0.0};
  double fcl{0.0};
  int fcl_compared{0};
  int fcl_silent{0};          // it threw, or reported no contact
  int fcl_wrong_overlaps{0};  // clear called overlapping, or the reverse
};

void compareWithFcl(const ShapePair& pair, double truth, Worst& worst) {
  const auto object_a = toFcl(pair.a, pair.world_from_a);
  const auto object_b = toFcl(pair.b, pair.world_from_b);
  if (!object_a || !object_b) {
    return;
  }
  ++worst.fcl_compared;
  const std::optional<bool> overlap = fclOverlap(*object_a, *object_b);
  if (overlap && std::abs(truth) > kDecided && *overlap != (truth < 0.0)) {
    ++worst.fcl_wrong_overlaps;
  }
  std::optional<double> answer = fclDistance(*object_a, *object_b);
  if (truth < 0.0) {
    answer = fclDepth(*object_a, *object_b);
    answer = answer ? std::optional<double>(-*answer) : std::nullopt;
  }
  if (!overlap || !answer) {
    ++worst.fcl_silent;
    return;
  }
  // For shapes it sees as overlapping FCL's distance is a mark, not a length.
  worst.fcl = std::max(worst.fcl, std::abs(std::max(*answer, truth < 0.0 ? *answer : 0.0) - truth));
}

// Near pairs are apart or overlap by as little: two classes.
struct Class {
  const char* name;
  Nearness nearness;
  bool (*holds)(double truth);
};
bool isAny(double) { return true; }
bool isApart(double truth) { return truth >= 0.0; }
bool isOverlap(double truth) { return truth < 0.0; }
constexpr Class kClasses[] = {{"separated", Nearness::separated, isAny},
                              {"near", Nearness::near, isApart},
                              {"touching", Nearness::touching, isAny},
                              {"overlapping, shallow", Nearness::near, isOverlap},
                              {"overlapping, deep", Nearness::overlapping, isAny}};

Worst measureRow(const PairRecipe& recipe, const Class& kind) {
  Worst worst;
  Random random(kSeed);
  for (int i = 0; i < kPairsPerRow; ++i) {
    const ShapePair pair = randomPair(recipe, random);
    const double truth =
        referenceDistance(pair.a, pair.world_from_a, pair.b, pair.world_from_b).distance;
    if (!kind.holds(truth)) {
      continue;
    }
    const double found =
        distanceBetween(pair.a, pair.world_from_a, pair.b, pair.world_from_b).distance;
    // Written so that NaN counts as the worst.
    worst.ours = std::abs(found - truth) <= worst.ours ? worst.ours : std::abs(found - truth);
    compareWithFcl(pair, truth, worst);
  }
  return worst;
}

void printRow(const PairRecipe& recipe, const Class& kind, const Worst& worst) {
  std::printf("| %s-%s | %s | %.1e | ", nameOf(recipe.a), nameOf(recipe.b), kind.name, worst.ours);
  if (worst.fcl_compared == 0) {
    std::printf("no such shape | | |\n");
    return;
  }
  std::printf("%.1e | %d | %d |\n", worst.fcl, worst.fcl_wrong_overlaps, worst.fcl_silent);
}

void runTable(double least_length, double greatest_length, Alignment alignment) {
  std::printf("\n%s rotations, lengths %g to %g m, %d pairs a row, seed %llu\n\n",
              nameOf(alignment), 2.0 * least_length, 2.0 * greatest_length, kPairsPerRow,
              static_cast<unsigned long long>(kSeed));
  std::printf(
      "| pair | pairs are | our worst error [m] | FCL's worst error [m] | "
      "FCL's wrong overlaps | FCL silent |\n|---|---|---|---|---|---|\n");
  for (const ShapeKind a : kShapeKinds) {
    for (const ShapeKind b : kShapeKinds) {
      for (const Class& kind : kClasses) {
        if (a > b) {
          continue;
        }
        const PairRecipe recipe{a, b, kind.nearness, alignment, least_length, greatest_length};
        const Worst worst = measureRow(recipe, kind);
        printRow(recipe, kind, worst);
        EXPECT_LE(worst.ours, kExact) << nameOf(a) << "-" << nameOf(b) << " " << kind.name;
      }
    }
  }
}

TEST(DistanceOracle, robotSizedPairs_table) { runTable(0.01, 0.5, Alignment::random); }

TEST(DistanceOracle, allSizes_table) { runTable(5e-4, 5.0, Alignment::random); }

TEST(DistanceOracle, alignedPairs_table) { runTable(5e-4, 5.0, Alignment::aligned); }

TEST(DistanceOracle, nearlyParallelPairs_table) { runTable(5e-4, 5.0, Alignment::near_parallel); }

// Where FCL measures in closed form it has to agree: a second witness beside our own reference.
// Its box-box and capsule-box distances are iterated and off by millimetres, see the tables.
TEST(DistanceOracle, robotSizedPairsApart_agreeWithFcl) {
  constexpr std::pair<ShapeKind, ShapeKind> kClosedForm[] = {
      {ShapeKind::sphere, ShapeKind::sphere},
      {ShapeKind::sphere, ShapeKind::capsule},
      {ShapeKind::sphere, ShapeKind::box},
      {ShapeKind::capsule, ShapeKind::capsule}};
  for (const auto& [a, b] : kClosedForm) {
    Random random(kSeed);
    for (int i = 0; i < kPairsPerRow; ++i) {
      const ShapePair pair =
          randomPair({a, b, Nearness::separated, Alignment::random, 0.01, 0.5}, random);
      const auto fcl =
          fclDistance(*toFcl(pair.a, pair.world_from_a), *toFcl(pair.b, pair.world_from_b));
      ASSERT_TRUE(fcl.has_value());
      const double ours =
          distanceBetween(pair.a, pair.world_from_a, pair.b, pair.world_from_b).distance;
      ASSERT_NEAR(ours, *fcl, kExact) << describe(pair);
    }
  }
}

}  // namespace
}  // namespace collision_monitor::test::distance_oracle
