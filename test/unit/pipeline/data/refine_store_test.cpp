// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/data/refine_store.h"

#include <gtest/gtest.h>

namespace collision_monitor {
namespace {

constexpr auto kMost = static_cast<ElementPairIndex>(RefineRoom::kMostPlain);

std::vector<RefineKind> plainPairs(std::size_t count) {
  return std::vector<RefineKind>(count, RefineKind::plain);
}

/// Leaves the number of steps that names the pair.
void mark(RefineStore& store, ElementPairIndex pair) { store.of(pair).last.found.work = pair + 1; }

TEST(RefineStore, fewPairs_eachKeepsItsOwn) {
  RefineStore store(plainPairs(kMost));
  for (ElementPairIndex pair = 0; pair < kMost; ++pair) {
    mark(store, pair);
  }
  for (ElementPairIndex pair = 0; pair < kMost; ++pair) {
    ASSERT_EQ(store.lastOf(pair).found.work, pair + 1);
  }
}

TEST(RefineStore, morePairsThanMemories_thoseAskedForLastKeepTheirs) {
  RefineStore store(plainPairs(3 * std::size_t{kMost}));
  for (ElementPairIndex pair = 0; pair < kMost; ++pair) {
    mark(store, pair);
  }
  store.of(0);
  mark(store, kMost);
  EXPECT_EQ(store.lastOf(0).found.work, 1U) << "asked for again";
  EXPECT_EQ(store.lastOf(1).found.work, 0U) << "the oldest";
  EXPECT_EQ(store.lastOf(2).found.work, 3U);
  EXPECT_EQ(store.lastOf(kMost).found.work, kMost + 1);
  EXPECT_EQ(store.of(1).last.found.work, 0U) << "as new, of whose ever it was";
}

TEST(RefineStore, meshes_haveWhatTheirKindSays) {
  RefineStore store({RefineKind::never, RefineKind::plain, RefineKind::front, RefineKind::depth,
                     RefineKind::both});
  for (ElementPairIndex pair = 1; pair < 5; ++pair) {
    EXPECT_EQ(store.of(pair).front != nullptr, pair == 2 || pair == 4) << pair;
    EXPECT_EQ(store.of(pair).depth, nullptr) << "not asked for yet";
    KeptDepth* const depth = keptDepth(store.of(pair));
    EXPECT_EQ(depth != nullptr, pair == 3 || pair == 4) << pair;
    EXPECT_EQ(keptDepth(store.of(pair)), depth) << pair;
  }
}

TEST(RefineStore, pairsOfMeshes_keepTheirProbesApart) {
  RefineStore store({RefineKind::both, RefineKind::front, RefineKind::both}, 100);
  const KeptProbes first = store.of(0).front->probes;
  EXPECT_EQ(first.count, 100U);
  EXPECT_EQ(store.of(1).front->probes.count, 0U) << "only one of them is a mesh";
  const KeptProbes other = store.of(2).front->probes;
  ASSERT_EQ(other.count, 100U);
  first.first[99].hold = 1.0;
  other.first[0].hold = 2.0;
  EXPECT_EQ(first.first[99].hold, 1.0);
  store.forgetAll();
  EXPECT_EQ(first.first[99].hold, 0.0);
  EXPECT_EQ(other.first[0].hold, 0.0);
}

TEST(RefineStore, moreProbesThanAreKept) {
  RefineStore store({RefineKind::both}, 100'000);
  EXPECT_EQ(store.of(0).front->probes.count, RefineRoom::kMostProbes);
}

TEST(RefineStore, pairWhoseBodiesSayAll_hasOneAllTheSame) {
  RefineStore store({RefineKind::never, RefineKind::never});
  mark(store, 0);
  mark(store, 1);
  EXPECT_EQ(store.lastOf(1).found.work, 2U);
  EXPECT_EQ(store.lastOf(0).found.work, 0U);
}

TEST(RefineStore, forgetAll_leavesAllAsNew) {
  RefineStore store(plainPairs(2));
  mark(store, 0);
  mark(store, 1);
  store.forgetAll();
  EXPECT_EQ(store.lastOf(0).found.work, 0U);
  EXPECT_EQ(store.lastOf(1).found.work, 0U);
}

TEST(RefineStore, pairsOfRobots_goToAnotherStoreUnderNewNumbers) {
  // The second pair is of an object; in the next store, the first is.
  RefineStore former({RefineKind::front, RefineKind::plain, RefineKind::plain}, 0, {0, 1, 0});
  RefineStore next({RefineKind::plain, RefineKind::front, RefineKind::plain}, 0, {1, 0, 0});
  for (ElementPairIndex pair = 0; pair < 3; ++pair) {
    mark(former, pair);
    mark(next, pair);
  }
  const MeshFront* const front = former.of(0).front;
  next.takeRobots(former, {1, kNone, 2});
  EXPECT_EQ(next.lastOf(1).found.work, 1U);
  EXPECT_EQ(next.lastOf(2).found.work, 3U);
  EXPECT_EQ(next.lastOf(0).found.work, 1U) << "its own";
  EXPECT_EQ(next.of(1).front, front);
  EXPECT_EQ(former.lastOf(0).found.work, 0U);
  EXPECT_EQ(former.lastOf(1).found.work, 2U) << "of an object";
  mark(former, 0);  // may go on
  EXPECT_EQ(former.lastOf(0).found.work, 1U);
}

}  // namespace
}  // namespace collision_monitor
