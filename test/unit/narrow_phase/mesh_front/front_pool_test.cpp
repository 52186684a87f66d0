// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "narrow_phase/mesh_front/mesh_front.h"

namespace collision_monitor::test {
namespace {

TEST(FrontPool, noneLeft_growsNoFront) {
  FrontPool pool(2);
  MeshFront one(pool);
  MeshFront other(pool);
  EXPECT_TRUE(pool.grow(one));
  EXPECT_TRUE(pool.grow(other));
  EXPECT_FALSE(pool.grow(one));
  EXPECT_EQ(one.block_count, 1U);
  EXPECT_NE(one.blocks[0], other.blocks[0]);
}

TEST(FrontPool, cleared_givesItsBlocksToOthers) {
  FrontPool pool(2);
  MeshFront one(pool);
  MeshFront other(pool);
  pool.grow(one);
  pool.grow(one);
  one.size = 700;
  pool.clear(one);
  EXPECT_EQ(one.size, 0U);
  EXPECT_LT(one.cover, 0.0);  // nothing stands for what was kept
  EXPECT_TRUE(pool.grow(other));
  EXPECT_TRUE(pool.grow(other));
}

TEST(FrontPool, mostBlocks_growsNoFarther) {
  FrontPool pool(MeshFront::kMostBlocks + 1);
  MeshFront front(pool);
  while (pool.grow(front)) {
  }
  EXPECT_EQ(front.block_count, MeshFront::kMostBlocks);
}

TEST(FrontPool, unaskedForLong_givesItsBlocksToOthers) {
  FrontPool pool(1);
  MeshFront old(pool);
  MeshFront young(pool);
  pool.touch(old);
  pool.grow(old);
  old.size = 3;
  pool.touch(young);
  EXPECT_FALSE(pool.grow(young));  // both are asked in turn
  for (int query = 0; query < 10000; ++query) {
    pool.touch(young);
  }
  EXPECT_TRUE(pool.grow(young));
  EXPECT_EQ(old.block_count, 0U);
  EXPECT_EQ(old.size, 0U);
}

TEST(FrontPool, askedForLast_keepsItsBlocks) {
  FrontPool pool(2);
  MeshFront first(pool);
  MeshFront second(pool);
  MeshFront third(pool);
  for (MeshFront* front : {&first, &second}) {
    pool.touch(*front);
    pool.grow(*front);
  }
  for (int query = 0; query < 10000; ++query) {
    pool.touch(first);
  }
  EXPECT_TRUE(pool.grow(third));
  EXPECT_EQ(first.block_count, 1U);
  EXPECT_EQ(second.block_count, 0U);
}

}  // namespace
}  // namespace collision_monitor::test
