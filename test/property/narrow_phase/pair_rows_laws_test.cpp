// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <memory>
#include <tuple>
#include <vector>

#include "collision_monitor/narrow_phase/pair_rows.h"
#include "narrow_phase/distance.h"
#include "support/expect_distance.h"
#include "support/fixed_seed.h"
#include "support/instruction_sets.h"
#include "support/random_pairs.h"

// Batched distances against the plain twin, on every instruction set of this machine.
namespace collision_monitor::test::pair_rows_laws {
namespace {

/// Pairs a case and of quick ones a kind; COLLISION_MONITOR_QUICK_PAIRS asks for more of those.
constexpr std::size_t kPairsPerCase = 4 * kRowCount;
std::size_t quickPairs() {
  const char* asked = std::getenv("COLLISION_MONITOR_QUICK_PAIRS");
  return asked != nullptr ? static_cast<std::size_t>(std::atol(asked)) : 20000;
}

std::unique_ptr<PairRows> rowsOf(const std::vector<ShapePair>& pairs) {
  auto rows = std::make_unique<PairRows>();
  for (std::size_t row = 0; row < pairs.size(); ++row) {
    writeRow(coreOf(pairs[row].a), pairs[row].world_from_a, row, rows->a);
    writeRow(coreOf(pairs[row].b), pairs[row].world_from_b, row, rows->b);
  }
  measureRows(coreKindOf(pairs[0].a), coreKindOf(pairs[0].b), pairs.size(), *rows);
  return rows;
}

void expectAsPlain(const ShapePair& pair, const SignedDistance& found) {
  const SignedDistance plain =
      distanceBetween(pair.a, pair.world_from_a, pair.b, pair.world_from_b);
  ASSERT_NEAR(found.distance, plain.distance, kExact);
  const auto offSurface = [](const Shape& shape, const Pose& pose, const Eigen::Vector3d& point) {
    return std::abs(signedDistanceTo(shape, inverse(pose) * point));
  };
  ASSERT_LE(offSurface(pair.a, pair.world_from_a, found.point_on_a), kExact);
  ASSERT_LE(offSurface(pair.b, pair.world_from_b, found.point_on_b), kExact);
  ASSERT_NEAR(found.normal_a_to_b.norm(), 1.0, kExact);
}

/// Every instruction set gives the bytes of the first, and those agree with the plain twin.
void expectAgreement(const std::vector<ShapePair>& pairs) {
  std::unique_ptr<PairRows> first;
  for (const std::int64_t target : instructionSets()) {
    SCOPED_TRACE(hwy::TargetName(target));
    const OnlyInstructionSet only(target);
    auto rows = rowsOf(pairs);
    for (std::size_t row = 0; row < pairs.size(); ++row) {
      SignedDistance found;
      readAnswer(*rows, row, false, found);
      if (first) {
        SignedDistance expected;
        readAnswer(*first, row, false, expected);
        ASSERT_EQ(std::memcmp(&found, &expected, sizeof found), 0) << describe(pairs[row]);
      } else {
        expectAsPlain(pairs[row], found);
        ASSERT_FALSE(testing::Test::HasFailure()) << describe(pairs[row]);
      }
    }
    first = first ? std::move(first) : std::move(rows);
  }
}

using Case = std::tuple<ShapeKind, ShapeKind, Nearness, Alignment>;

class PairRowsLaws : public testing::TestWithParam<Case> {};

TEST_P(PairRowsLaws, agreeWithThePlainTwin) {
  const auto [kind_a, kind_b, nearness, alignment] = GetParam();
  if (kind_a > kind_b) {
    return;  // rows are in canonical order
  }
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  Random random(kSeed);
  for (const bool with_zero_lengths : {false, true}) {
    const PairRecipe recipe{kind_a, kind_b, nearness, alignment, 1e-3, 5.0, with_zero_lengths};
    for (std::size_t done = 0; done < kPairsPerCase; done += kRowCount) {
      std::vector<ShapePair> pairs;
      while (pairs.size() < kRowCount - done % 7) {  // vectors that are not full, too
        pairs.push_back(randomPair(recipe, random));
      }
      ASSERT_NO_FATAL_FAILURE(expectAgreement(pairs));
    }
  }
}

std::string nameOfCase(const testing::TestParamInfo<Case>& info) {
  const auto [a, b, nearness, alignment] = info.param;
  return std::string(nameOf(a)) + "_" + nameOf(b) + "_" + nameOf(nearness) + "_" +
         nameOf(alignment);
}

INSTANTIATE_TEST_SUITE_P(AllPairs, PairRowsLaws,
                         testing::Combine(testing::ValuesIn(kShapeKinds),
                                          testing::ValuesIn(kShapeKinds),
                                          testing::ValuesIn(kNearnesses),
                                          testing::ValuesIn(kAlignments)),
                         nameOfCase);

TEST(PairRowsQuick, randomPairsOfEveryKindAgreeWithThePlainTwin) {
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  Random random(kSeed);
  const Shape shapes[] = {Sphere{0.1}, Capsule{0.3, 0.05}, RoundedBox{{0.1, 0.2, 0.3}, 0.02}};
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = a; b < 3; ++b) {
      for (std::size_t done = 0; done < quickPairs(); done += kRowCount) {
        std::vector<ShapePair> pairs;
        while (pairs.size() < kRowCount) {
          pairs.push_back({shapes[a], randomPose(random, 0.5), shapes[b], randomPose(random, 0.5)});
        }
        ASSERT_NO_FATAL_FAILURE(expectAgreement(pairs));
      }
    }
  }
}

}  // namespace
}  // namespace collision_monitor::test::pair_rows_laws
